// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_error.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "sky/base/error.h"
#include "sky/cubemap/day_bends.h"
#include "sky/cubemap/dome_scale.h"

namespace welkin::cubemap {
namespace {

/// Numbers of directions and instants that an effort takes.
struct Density {
  DirectionCounts directions;
  double apart_h;  // instants between two cubemaps are at most this apart
  int pieces;      // and they cut every gap at least into as many
  int rounds;      // closer looks around the worst instant
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

/// The measurement at one instant.
struct AtInstant {
  double error = 0.0;
  int channel = 0;
  CubemapError::Largest largest;
  CubemapError::Parts parts;
};

class Measurement {
 public:
  Measurement(const model::Sky& sky, const CubemapSet& cubemaps, const DirectionCounts& counts)
      : scale_(sky), looks_(sky, cubemaps, counts) {}

  CubemapLook lookAt(std::size_t cubemap) const { return {looks_, cubemap}; }

  /// At an instant between two cubemaps, or at the first one's time.
  AtInstant at(double time_h, const CubemapLook& first, const CubemapLook& second) const {
    const CubemapSet& cubemaps = looks_.cubemaps();
    const model::SkyInstant instant(looks_.sky(), time_h);
    const double weight = format::findSegment(cubemaps.time_h, time_h).weight;
    const bool baked = weight == 0.0;
    Number3 mean(0.0);
    double whole = 0.0;
    double compared = 0.0;
    Squares shown;
    Squares unencoded;
    Squares rounding;
    Squares blending;
    Number3 largest(0.0);
    Number3 where[3];
    RecentTexels recent_of_first;
    RecentTexels recent_of_second;
    const std::size_t staying = looks_.staying().size();
    const auto directions = looks_.directionsAround(instant.sunDirection());
    for (std::size_t i = 0; i < directions.size(); ++i) {
      const auto& [direction, solid_angle] = directions[i];
      const bool stays = i < staying;
      const model::DomeRay ray = stays ? looks_.staying()[i].ray : model::DomeRay(looks_.sky().luminance, direction);
      const Number3 model = instant.dome(ray, looks_.table());
      mean += model * solid_angle;
      whole += solid_angle;
      if (!(stays ? looks_.staying()[i].compared : isClearOfHorizon(cubemaps.size, direction))) continue;
      compared += solid_angle;
      const Footprint footprint = stays ? looks_.staying()[i].footprint : footprintOf(cubemaps.size, direction);
      const auto in = [&](const CubemapLook& look, RecentTexels& recent) {
        return stays ? look.staying(i) : look.at(ray, footprint, recent, baked);
      };
      const CubemapLook::Shown before = in(first, recent_of_first);
      Number3 difference = before.shown - model;
      if (baked) {
        unencoded.add(before.exact - model, solid_angle);
        rounding.add(before.shown - before.exact, solid_angle);
      } else {
        const CubemapLook::Shown after = in(second, recent_of_second);
        difference = mix(before.shown, after.shown, weight) - model;
        blending.add(mix(before.model, after.model, weight) - model, solid_angle);
      }
      shown.add(difference, solid_angle);
      for (int c = 0; c < 3; ++c)
        if (std::abs(difference[c]) > largest[c]) {
          largest[c] = std::abs(difference[c]);
          where[c] = direction;
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
  DomeScale scale_;
  CubemapLooks looks_;
};

std::vector<double> instantsOf(const model::Sky& sky, const std::vector<double>& baked, const Density& density) {
  std::vector<double> time_h = bendsOf(sky);
  for (std::size_t i = 0; i < baked.size(); ++i) {
    const double next = i + 1 < baked.size() ? baked[i + 1] : baked.front() + 24.0;
    const int halves = static_cast<int>(std::ceil((next - baked[i]) / (2.0 * density.apart_h)));
    const int pieces = std::max(density.pieces, 2 * halves);  // the middle is always one
    for (int k = 0; k < pieces; ++k) time_h.push_back(baked[i] + (next - baked[i]) * k / pieces);
  }
  tidyHours(time_h);
  return time_h;
}

/// An instant and its measurement.
struct MeasuredInstant {
  double time_h;
  AtInstant at;
};

/// The instant of the largest error; the first of equals.
std::size_t worstOf(const std::vector<MeasuredInstant>& measured) {
  std::size_t worst = 0;
  for (std::size_t i = 1; i < measured.size(); ++i)
    if (measured[i].at.error > measured[worst].at.error) worst = i;
  return worst;
}

CubemapError summaryOf(const std::vector<MeasuredInstant>& measured) {
  CubemapError result;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    const auto& [time_h, at] = measured[i];
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
    const double before = i > 0 ? measured[i - 1].time_h : measured.back().time_h - 24.0;
    const double after = i + 1 < measured.size() ? measured[i + 1].time_h : measured.front().time_h + 24.0;
    result.mean += at.error * (after - before) / 48.0;  // half of the span between the neighbours
  }
  return result;
}

}  // namespace

CubemapError measureCubemaps(const model::Sky& sky, const CubemapSet& cubemaps, Effort effort,
                             const base::Progress& progress) {
  const Density density = densityOf(effort);
  const Measurement measurement(sky, cubemaps, density.directions);
  const std::size_t count = cubemaps.time_h.size();
  std::vector<MeasuredInstant> measured;
  for (const double time_h : instantsOf(sky, cubemaps.time_h, density)) measured.push_back({time_h, {}});
  const auto measure = [&](std::vector<MeasuredInstant>& list) {
    std::vector<std::vector<MeasuredInstant*>> gaps(count);
    for (MeasuredInstant& at : list) gaps[format::findSegment(cubemaps.time_h, at.time_h).first].push_back(&at);
    constexpr std::size_t kGapsAtOnce = 4;  // two that meet share the look at the cubemap between them
    tbb::parallel_for(std::size_t{0}, (count + kGapsAtOnce - 1) / kGapsAtOnce, [&](std::size_t block) {
      std::optional<CubemapLook> next;
      for (std::size_t i = block * kGapsAtOnce; i < std::min((block + 1) * kGapsAtOnce, count); ++i) {
        const std::vector<MeasuredInstant*>& gap = gaps[i];
        if (gap.empty()) {
          next.reset();
          continue;
        }
        const CubemapLook first = next ? std::move(*next) : measurement.lookAt(i);
        next.emplace(measurement.lookAt((i + 1) % count));
        tbb::parallel_for(std::size_t{0}, gap.size(), [&](std::size_t k) {
          gap[k]->at = measurement.at(gap[k]->time_h, first, *next);
          progress.step();
        });
      }
    });
  };
  measure(measured);
  for (int round = 0; round < density.rounds && measured.size() > 1; ++round) {
    const std::size_t worst = worstOf(measured);
    const double here = measured[worst].time_h;
    const double before = worst > 0 ? measured[worst - 1].time_h : measured.back().time_h - 24.0;
    const double after = worst + 1 < measured.size() ? measured[worst + 1].time_h : measured.front().time_h + 24.0;
    std::vector<MeasuredInstant> closer = {{format::wrapTime(0.5 * (before + here)), {}},
                                           {format::wrapTime(0.5 * (here + after)), {}}};
    measure(closer);
    measured.insert(measured.end(), closer.begin(), closer.end());
    std::sort(measured.begin(), measured.end(),
              [](const MeasuredInstant& a, const MeasuredInstant& b) { return a.time_h < b.time_h; });
  }
  return summaryOf(measured);
}

std::vector<CubemapError::Parts> partsAt(const model::Sky& sky, const CubemapSet& cubemaps,
                                         const base::Progress& progress) {
  const Measurement measurement(sky, cubemaps, {512, 256, 256});
  std::vector<CubemapError::Parts> parts(cubemaps.time_h.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    const CubemapLook look = measurement.lookAt(i);
    parts[i] = measurement.at(cubemaps.time_h[i], look, look).parts;
    progress.step();
  });
  return parts;
}

}  // namespace welkin::cubemap
