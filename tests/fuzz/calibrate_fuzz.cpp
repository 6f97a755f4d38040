// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a photograph for `welkin calibrate`, from the search of a chart to the albedo. The number
// of bytes chooses the options: whether the corners are given, and whether the light's gradient is taken out.
#include <algorithm>

#include "calibrate/chart_module.h"
#include "calibrate/judge.h"
#include "calibrate/photo.h"
#include "calibrate/report.h"
#include "fuzz.h"
#include "sky/image/image_module.h"

namespace {

using namespace welkin;

calibrate::PhotoOptions optionsOf(const image::Image& image, std::size_t size) {
  calibrate::PhotoOptions options;
  options.reference = calibrate::referenceChart(calibrate::Edition::after_2014);
  options.model = "3x3";  // the choice among all models takes seconds under a sanitizer
  options.encoding = calibrate::Encoding::srgb;
  options.flatten = size % 4 == 0;
  const double w = image.width, h = image.height;  // where the seeds' chart is
  if (size % 2 != 0)
    options.corners =
        calibrate::Corners{calibrate::Point(0.1875 * w, 0.2083 * h), calibrate::Point(0.8125 * w, 0.2083 * h),
                           calibrate::Point(0.8125 * w, 0.7708 * h), calibrate::Point(0.1875 * w, 0.7708 * h)};
  return options;
}

/// No number of the tree is infinite or NaN, which JSON would print as null.
bool isFinite(const nlohmann::ordered_json& json) {
  if (json.is_number_float()) return std::isfinite(json.get<double>());
  return std::all_of(json.begin(), json.end(), [&](const auto& child) {
    return !child.is_structured() && !child.is_number_float() ? true : isFinite(child);
  });
}

void requireSound(const calibrate::CalibratedPhoto& photo, const calibrate::PhotoOptions& options) {
  fuzz::require(!photo.charts.empty(), "there is a chart");
  for (const calibrate::FoundChart& chart : photo.charts) {
    fuzz::require(chart.confidence >= calibrate::kLeastLikeness && chart.confidence <= 1.0, "its confidence is enough");
    for (const calibrate::Point& p : chart.place.corners())
      fuzz::require(p.x() >= 0.0 && p.y() >= 0.0 && p.x() <= photo.image.width && p.y() <= photo.image.height,
                    "its corners lie within the picture");
  }
  fuzz::require(photo.calibration.used.size() >= calibrate::kLeastPatches, "patches enough are used");
  fuzz::require(isFinite(calibrate::reportJson(photo, options.reference)), "the report's numbers are finite");
  const image::Image albedo = calibrate::albedoOf(photo.image, photo.calibration.model);
  fuzz::require(albedo.rgb.size() == photo.image.rgb.size(), "every texel has an albedo");
  fuzz::require(
      std::all_of(albedo.rgb.begin(), albedo.rgb.end(), [](float v) { return std::isfinite(v) && v >= 0.0F; }),
      "albedo is finite and not negative");
}

}  // namespace

/// Loads the modules before the time of an input counts.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  image::imageModule();
  calibrate::chartModule();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  static const fuzz::Folder kFolder;
  const auto path = kFolder.write("photo", {bytes, size});
  image::ImageLimits limits;
  limits.negative = true;
  limits.most_texels = std::size_t{1} << 16;  // larger ones take long, and reach nothing else
  image::Image image;
  if (!fuzz::accepts([&] { image = image::readImage(path, limits); })) return 0;
  const calibrate::PhotoOptions options = optionsOf(image, size);
  fuzz::accepts([&] { requireSound(calibrate::calibratePhoto(path, options), options); });
  return 0;
}
