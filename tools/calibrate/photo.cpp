// SPDX-License-Identifier: Apache-2.0
#include "calibrate/photo.h"

#include <fmt/format.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/base/hash.h"

namespace welkin::calibrate {
namespace {

[[noreturn]] void refuse(const std::string& photo, const std::string& why) {
  throw base::Error(base::ExitStatus::content, fmt::format("{}: {}", photo, why));
}

/// The charts among areas that may be some. Throws with the reason of the likeliest one's refusal.
std::vector<FoundChart> chartsOf(const std::string& photo, const image::Image& image, const PhotoOptions& options,
                                 const std::vector<Corners>& areas, double full) {
  std::vector<FoundChart> charts;
  const std::vector<Judgement> verdicts = judgeAll(image, areas, options.reference, full, !options.corners);
  if (verdicts.empty()) refuse(photo, "no ColorChecker Classic was found; --corners names the corners of one by hand");
  if (!verdicts[0].place)
    refuse(photo,
           fmt::format("{}: {}", options.corners ? "the chart at --corners" : "no chart to trust: what looks like one",
                       verdicts[0].refusal));
  for (const Judgement& v : verdicts) charts.push_back({*v.place, v.match.likeness, v.patches});
  return charts;
}

/// Calibrates the photograph as one encoding. `areas` may be charts; an empty list is filled by a search.
CalibratedPhoto calibrated(const std::string& photo, std::span<const std::byte> bytes, const PhotoOptions& options,
                           bool linear_codes, std::vector<Corners>& areas) {
  CalibratedPhoto result;
  image::ImageLimits limits = kPhotoLimits;
  limits.linear_codes = linear_codes;
  limits.negative = true;  // a profile may hold colours past Rec. 709
  result.image = image::readImage(photo, bytes, limits);
  result.linear_codes = linear_codes;
  const double full = clippingLevel(result.image, linear_codes);
  if (areas.empty()) areas = areasIn(result.image, options.reference, full);
  result.charts = chartsOf(photo, result.image, options, areas, full);
  Patches& patches = result.charts[0].patches;
  result.calibration = calibratePatches(photo, patches, options.reference, options.model);
  if (options.flatten) {
    result.light = gradientOf(patches, options.reference, result.calibration.used);
    patches = withoutGradient(patches, *result.light);
    result.calibration = calibratePatches(photo, patches, options.reference, options.model);
  }
  return result;
}

/// Codes are read as linear only if that leaves an error clearly below that of sRGB, as most pictures are.
constexpr double kClearlyBetter = 0.8;

double leftOut(const CalibratedPhoto& photo) {
  return summaryOf(photo.calibration.errors().left_out).mean;
}

void warnOf(CalibratedPhoto& photo) {
  const FoundChart& chart = photo.charts[0];
  for (std::size_t i = 0; i < kPatches; ++i) {
    if (chart.patches[i].isClipped())
      photo.warnings.push_back(fmt::format("the patch {} is overexposed and was left out", patchName(i)));
    else if (chart.patches[i].isUneven())
      photo.warnings.push_back(
          fmt::format("the patch {} holds an edge, of a shadow perhaps, and was left out", patchName(i)));
  }
  for (std::size_t i = 0; i < kPatches; ++i)
    if (chart.patches[i].is_foreign)
      photo.warnings.push_back(
          fmt::format("the patch {} has another colour than the chart's and was left out", patchName(i)));
  photo.warnings.insert(photo.warnings.end(), photo.image.notes.begin(), photo.image.notes.end());
}

}  // namespace

CalibratedPhoto calibratePhoto(const std::filesystem::path& path, const PhotoOptions& options) {
  const std::string name = path.string();
  const std::vector<std::byte> bytes = base::readFile(path);
  std::vector<Corners> areas;
  if (options.corners) areas.push_back(*options.corners);
  const auto tried = [&](bool linear_codes) { return calibrated(name, bytes, options, linear_codes, areas); };
  std::optional<CalibratedPhoto> best;
  if (options.encoding == Encoding::choose) {
    std::optional<base::Error> refusal;
    for (const bool linear_codes : {false, true}) {
      if (!best && !options.corners) areas.clear();  // where codes are read as other light, other places may stand out
      try {
        CalibratedPhoto other = tried(linear_codes);
        if (!best || leftOut(other) < kClearlyBetter * leftOut(*best)) best = std::move(other);
      } catch (const base::Error& e) {
        if (e.status() != base::ExitStatus::content) throw;
        if (!refusal) refusal = e;
      }
    }
    if (!best) throw *refusal;
  } else {
    best = tried(options.encoding == Encoding::linear);
  }
  for (std::size_t i = 1; i < best->charts.size(); ++i)
    best->others.push_back(errorOn(best->charts[i], best->calibration.model, options.reference));
  best->hash = base::textOf(base::hashOf(bytes));
  warnOf(*best);
  return std::move(*best);
}

image::Image albedoOf(const image::Image& image, const Model& model) {
  image::Image albedo;
  albedo.width = image.width;
  albedo.height = image.height;
  albedo.rgb.resize(image.rgb.size());
  const auto texels = image.rgb.size() / 3;
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, texels, 4096), [&](const auto& range) {
    for (std::size_t i = range.begin(); i < range.end(); ++i) {
      const float* from = image.rgb.data() + 3 * i;
      const Colour rgb = model({double{from[0]}, double{from[1]}, double{from[2]}});
      for (std::size_t c = 0; c < 3; ++c)
        albedo.rgb[3 * i + c] = static_cast<float>(std::max(0.0, rgb[static_cast<int>(c)]));
    }
  });
  return albedo;
}

}  // namespace welkin::calibrate
