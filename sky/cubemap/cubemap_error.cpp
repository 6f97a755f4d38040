// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sky/base/error.h"

namespace welkin::cubemap {
namespace {

constexpr double kDarkest = 1e-4;  // of the day's brightest instant

/// How many directions and instants an effort takes.
struct Density {
  DirectionCounts directions;
  double apart_h;  // instants between two cubemaps are at most this apart
  int pieces;      // and they cut every gap at least into as many
  int rounds;      // of looking closer around the worst instant
};
Density densityOf(Effort effort) {
  if (effort == Effort::draft) return {{512, 256, 256}, 0.25, 2, 2};
  if (effort == Effort::fast) return {{1536, 768, 768}, 0.25, 2, 2};
  return {{6144, 3072, 3072}, 0.125, 4, 4};
}

/// Sums over the directions of an instant, a number for each channel.
struct Squares {
  Number3 sum{0.0};
  void add(const Number3& difference, double weight) { sum += difference * difference * weight; }
};

/// What is measured at one instant.
struct AtInstant {
  double error = 0.0;
  int channel = 0;
  CubemapError::Largest largest;
  CubemapError::Parts parts;
};

class Measurement {
 public:
  Measurement(const model::Sky& sky, const CubemapSet& cubemaps, const DirectionCounts& counts)
      : sky_(sky), cubemaps_(cubemaps), scale_(sky), directions_(counts) {
    if (sky.luminance.d >= -model::IndicatrixTable::kSteepest) table_.emplace(sky.luminance.d);
    for (const double time_h : cubemaps.time_h) baked_.emplace_back(sky, time_h);
  }

  AtInstant at(double time_h) const {
    const model::SkyInstant instant(sky_, time_h);
    const format::KeySegment segment = format::findSegment(cubemaps_.time_h, time_h);
    const bool baked = segment.weight == 0.0;
    Number3 mean(0.0);
    double whole = 0.0;
    double compared = 0.0;
    Squares shown;
    Squares unencoded;
    Squares rounding;
    Squares blending;
    Number3 largest(0.0);
    Number3 where[3];
    for (const auto& [direction, solid_angle] : directions_.around(instant.sunDirection())) {
      const Number3 model = dome(instant, direction);
      mean += model * solid_angle;
      whole += solid_angle;
      if (!isClearOfHorizon(cubemaps_.size, direction)) continue;
      compared += solid_angle;
      const Footprint footprint = footprintOf(cubemaps_.size, direction);
      const Shown first = show(segment.first, footprint, baked);
      const Number3 difference =
          (baked ? first.shown : mix(first.shown, show(segment.second, footprint, false).shown, segment.weight)) -
          model;
      shown.add(difference, solid_angle);
      for (int c = 0; c < 3; ++c)
        if (std::abs(difference[c]) > largest[c]) {
          largest[c] = std::abs(difference[c]);
          where[c] = direction;
        }
      if (baked) {
        unencoded.add(first.exact - model, solid_angle);
        rounding.add(first.shown - first.exact, solid_angle);
      } else {
        blending.add(
            mix(dome(baked_[segment.first], direction), dome(baked_[segment.second], direction), segment.weight) -
                model,
            solid_angle);
      }
    }
    AtInstant result;
    mean = mean * (1.0 / whole);
    for (int c = 0; c < 3; ++c) {
      const double scale = scale_.of(mean, c);
      if (!(scale > 0.0) || !(compared > 0.0)) continue;
      const auto relative = [&](const Squares& squares) { return std::sqrt(squares.sum[c] / compared) / scale; };
      if (relative(shown) > result.error) {
        result.error = relative(shown);
        result.channel = c;
      }
      if (largest[c] / scale > result.largest.error) result.largest = {largest[c] / scale, time_h, where[c], c};
      result.parts.resolution = std::max(result.parts.resolution, relative(unencoded));
      result.parts.encoding = std::max(result.parts.encoding, relative(rounding));
      result.parts.time = std::max(result.parts.time, relative(blending));
    }
    return result;
  }

 private:
  Number3 dome(const model::SkyInstant& instant, const Number3& direction) const {
    return instant.dome(direction, Number3(0.0), table_ ? &*table_ : nullptr);
  }
  /// What a cubemap shows, and what it would without encoding.
  struct Shown {
    Number3 shown, exact;
  };
  /// From the file's bytes, or from those of the few texels that are seen; `exact` costs the model's evaluation.
  Shown show(std::size_t index, const Footprint& footprint, bool exact_too) const {
    const bool rendered = !cubemaps_.texels.empty();
    Shown sum{Number3(0.0), Number3(0.0)};
    if (rendered) sum.shown = filterTexels(cubemaps_.texels[index].data(), cubemaps_.format, footprint);
    if (rendered && !exact_too) return sum;
    for (const TexelShare& share : footprint) {
      if (!(share.weight > 0.0)) continue;
      const Number3 radiance = dome(baked_[index], directionOfTexel(cubemaps_.size, share.texel));
      sum.exact += radiance * share.weight;
      if (!rendered) sum.shown += rounded(radiance) * share.weight;
    }
    return sum;
  }
  Number3 rounded(const Number3& radiance) const {
    float rgb[3] = {static_cast<float>(radiance.x), static_cast<float>(radiance.y), static_cast<float>(radiance.z)};
    unsigned char texel[format::kMostTexelBytes];
    format::encodeTexel(cubemaps_.format, rgb, texel);
    format::decodeTexel(cubemaps_.format, texel, rgb);
    return {double{rgb[0]}, double{rgb[1]}, double{rgb[2]}};
  }

  const model::Sky& sky_;
  const CubemapSet& cubemaps_;
  DomeScale scale_;
  DomeDirections directions_;
  std::optional<model::IndicatrixTable> table_;
  std::vector<model::SkyInstant> baked_;
};

void tidy(std::vector<double>& time_h) {
  for (double& t : time_h) t = format::wrapTime(t);
  std::sort(time_h.begin(), time_h.end());
  time_h.erase(std::unique(time_h.begin(), time_h.end()), time_h.end());
}

std::vector<double> instantsOf(const model::Sky& sky, const std::vector<double>& baked, const Density& density) {
  std::vector<double> time_h = bendsOf(sky);
  for (std::size_t i = 0; i < baked.size(); ++i) {
    const double next = i + 1 < baked.size() ? baked[i + 1] : baked.front() + 24.0;
    const int halves = static_cast<int>(std::ceil((next - baked[i]) / (2.0 * density.apart_h)));
    const int pieces = std::max(density.pieces, 2 * halves);  // the middle is always one
    for (int k = 0; k < pieces; ++k) time_h.push_back(baked[i] + (next - baked[i]) * k / pieces);
  }
  tidy(time_h);
  return time_h;
}

}  // namespace

namespace {

constexpr int kMostColumns = 288;  // more are closer than five minutes: the instants between cubemaps meet them
constexpr double kBend = 0.002;    // of a texel that is worth an instant, of the brightest component, which is about 1

/// Columns at which a gradient's change over the day bends.
std::vector<int> bentColumns(const model::Gradient& gradient) {
  std::vector<int> list;
  const int n = gradient.width;
  for (int i = 0; i < n; ++i) {
    double most = 0.0;
    for (int j = 0; j < gradient.height; ++j) {
      const Number3 bend =
          gradient.texel((i + n - 1) % n, j) - gradient.texel(i, j) * 2.0 + gradient.texel((i + 1) % n, j);
      most = std::max({most, std::abs(bend.x), std::abs(bend.y), std::abs(bend.z)});
    }
    if (most > kBend) list.push_back(i);
  }
  return list;
}

}  // namespace

DomeScale::DomeScale(const model::Sky& sky) : floor_(0.0) {
  const DomeDirections directions({192, 0, 0});
  std::vector<double> time_h = bendsOf(sky);
  for (int i = 0; i < 96; ++i) time_h.push_back(0.25 * i);
  tidy(time_h);
  std::vector<double> mean(time_h.size());
  tbb::parallel_for(std::size_t{0}, time_h.size(), [&](std::size_t i) {
    const model::SkyInstant instant(sky, time_h[i]);
    for (const Number3& d : directions.even()) mean[i] += det::luminanceOf(instant.dome(d, Number3(0.0))) / 192.0;
  });
  floor_ = kDarkest * *std::max_element(mean.begin(), mean.end());
}

double DomeScale::of(const Number3& mean, int channel) const {
  return std::max({mean[channel], det::luminanceOf(mean), floor_});
}

std::vector<double> bendsOf(const model::Sky& sky) {
  std::vector<double> time_h;
  const auto height = [&](double t) { return sky.sun.path.directionAt(t).y; };
  constexpr int kSteps = 288;
  for (int i = 0; i < kSteps; ++i) {
    double low = 24.0 * i / kSteps;
    double high = 24.0 * (i + 1) / kSteps;
    const bool up = height(low) > 0.0;
    if (up == (height(high) > 0.0)) continue;
    while (high - low > 1e-6) {
      const double middle = 0.5 * (low + high);
      ((height(middle) > 0.0) == up ? low : high) = middle;
    }
    for (const double apart_h : {-0.12, -0.04, 0.0, 0.04, 0.12}) time_h.push_back(low + apart_h);
  }
  for (const model::Gradient* gradient : {&sky.gradient_sun, &sky.gradient_anti})
    if (gradient->width <= kMostColumns)
      for (const int i : bentColumns(*gradient)) time_h.push_back(24.0 * (i + 0.5) / gradient->width);
  for (const auto* keys : {&sky.intensity.time_h, &sky.polarising_tint.time_h, &sky.sun.path.key_time_h})
    time_h.insert(time_h.end(), keys->begin(), keys->end());
  tidy(time_h);
  return time_h;
}

bool isClearOfHorizon(int size, const Number3& direction) {
  return direction.y * size >= 2.0 * std::max(std::abs(direction.x), std::abs(direction.z));
}

namespace {

/// An instant and what was found there.
struct Found {
  double time_h;
  AtInstant at;
};

/// Where the error is largest; the first of equals.
std::size_t worstOf(const std::vector<Found>& found) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < found.size(); ++i)
    if (found[i].at.error > found[worst].at.error) worst = i;
  return worst;
}

CubemapError summaryOf(const std::vector<Found>& found) {
  CubemapError result;
  for (std::size_t i = 0; i < found.size(); ++i) {
    const auto& [time_h, at] = found[i];
    result.day.push_back({time_h, at.error});
    if (at.error > result.error) {
      result.error = at.error;
      result.time_h = time_h;
      result.channel = at.channel;
    }
    if (at.largest.error > result.largest.error) result.largest = at.largest;
    result.parts.resolution = std::max(result.parts.resolution, at.parts.resolution);
    result.parts.time = std::max(result.parts.time, at.parts.time);
    result.parts.encoding = std::max(result.parts.encoding, at.parts.encoding);
    const double before = i > 0 ? found[i - 1].time_h : found.back().time_h - 24.0;
    const double after = i + 1 < found.size() ? found[i + 1].time_h : found.front().time_h + 24.0;
    result.mean += at.error * (after - before) / 48.0;  // half of the span between the neighbours
  }
  return result;
}

}  // namespace

CubemapError measureCubemaps(const model::Sky& sky, const CubemapSet& cubemaps, Effort effort,
                             const table::Progress& progress) {
  const Density density = densityOf(effort);
  const Measurement measurement(sky, cubemaps, density.directions);
  std::vector<Found> found;
  for (const double time_h : instantsOf(sky, cubemaps.time_h, density)) found.push_back({time_h, {}});
  const auto measure = [&](std::vector<Found>& list) {
    tbb::parallel_for(std::size_t{0}, list.size(), [&](std::size_t i) {
      list[i].at = measurement.at(list[i].time_h);
      if (progress && !progress()) throw base::Error(base::ExitStatus::interrupted, "interrupted");
    });
  };
  measure(found);
  for (int round = 0; round < density.rounds && found.size() > 1; ++round) {
    const std::size_t worst = worstOf(found);
    const double here = found[worst].time_h;
    const double before = worst > 0 ? found[worst - 1].time_h : found.back().time_h - 24.0;
    const double after = worst + 1 < found.size() ? found[worst + 1].time_h : found.front().time_h + 24.0;
    std::vector<Found> closer = {{format::wrapTime(0.5 * (before + here)), {}},
                                 {format::wrapTime(0.5 * (here + after)), {}}};
    measure(closer);
    found.insert(found.end(), closer.begin(), closer.end());
    std::sort(found.begin(), found.end(), [](const Found& a, const Found& b) { return a.time_h < b.time_h; });
  }
  return summaryOf(found);
}

std::vector<CubemapError::Parts> partsAt(const model::Sky& sky, const CubemapSet& cubemaps,
                                         const table::Progress& progress) {
  const Measurement measurement(sky, cubemaps, {512, 256, 256});
  std::vector<CubemapError::Parts> parts(cubemaps.time_h.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    parts[i] = measurement.at(cubemaps.time_h[i]).parts;
    if (progress && !progress()) throw base::Error(base::ExitStatus::interrupted, "interrupted");
  });
  return parts;
}

}  // namespace welkin::cubemap
