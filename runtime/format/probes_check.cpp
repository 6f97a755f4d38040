// SPDX-License-Identifier: Apache-2.0
#include <bit>
#include <cmath>
#include <numeric>

#include "format/check_parts.h"
#include "format/domain_check.h"

namespace welkin::format {
namespace {

constexpr std::uint32_t kDirections = 4;
constexpr std::uint32_t kMostKnots = 8192;

bool areHours(std::span<const float> hours) {
  double before = -1.0;
  for (const float hour : hours) {
    if (!(double{hour} > before && hour >= 0.0F && hour < 24.0F)) return false;
    before = double{hour};
  }
  return true;
}

void checkModes(Check& check, const Probes& p, SunTransfer sun) {
  constexpr const char* kName = "the modes of the sun";
  const auto count = spanOf(p.mode_scale()).size();
  const auto sun_knots = spanOf(p.sun_time_h()).size();
  const auto moon_knots = spanOf(p.moon_time_h()).size();
  check.that(count <= kMostSunModes, kName, "must be at most 16");
  check.that(count == 0 || sun == SunTransfer::directional, kName, "must be none, for the sun is not directional");
  check.that(sun_knots <= kMostKnots && moon_knots <= kMostKnots, kName, "must have at most 8192 knots a light");
  check.that(spanOf(p.mode()).size() == 3 * count * (sun_knots + moon_knots), kName,
             "must have a number for every mode, knot and channel");
  check.that(spanOf(p.coefficient_scale()).size() == count, kName, "must have two scales each");
  check.that(areHours(spanOf(p.sun_time_h())) && areHours(spanOf(p.moon_time_h())), kName,
             "must have ascending knots in [0, 24)");
  check.that(within(spanOf(p.mode_scale()), 0.0, kAny) && within(spanOf(p.coefficient_scale()), 0.0, kAny), kName,
             "have a scale out of its domain");
}

}  // namespace

bool areScales(std::span<const std::uint16_t> scales) {
  return std::all_of(scales.begin(), scales.end(), [](std::uint16_t bits) {
    const float scale = std::bit_cast<float>(std::uint32_t{bits} << 16);
    return !std::signbit(scale) && within(double{scale}, 0.0, kAny);
  });
}

void checkProbes(Check& check, const Probes& p, SunTransfer sun) {
  constexpr const char* kName = "the probes";
  const std::size_t n = spanOf(p.sky_scale()).size();
  const std::size_t modes = spanOf(p.mode_scale()).size();
  check.that(n <= kMostProbes, kName, "must be at most 255");
  check.that(within(double{p.low_y()}, -kFarthest_m, kFarthest_m) &&
                 within(double{p.high_y()}, double{p.low_y()}, kFarthest_m),
             kName, "have a height out of its domain");
  check.that(spanOf(p.position()).size() == 3 * n, kName, "must have a position each");
  check.that(spanOf(p.visibility()).size() == 3 * n, kName, "must have a visibility for every direction up");
  check.that(spanOf(p.sky()).size() == kDirections * 2 * 3 * n && spanOf(p.sky_side()).size() == spanOf(p.sky()).size(),
             kName, "must have every coefficient of the sky");
  checkModes(check, p, sun);
  check.that(spanOf(p.sun_scale()).size() == (modes > 0 ? n : 0) && spanOf(p.sun()).size() == kDirections * modes * n,
             kName, "must have a number of the sun for every direction and mode");
  const std::size_t emitting = spanOf(p.emitted_scale()).size();
  check.that((emitting == 0 || emitting == n) && spanOf(p.emitted()).size() == kDirections * 3 * emitting, kName,
             "must have emitted light for every direction and channel, or none at all");
  check.that(
      areScales(spanOf(p.sky_scale())) && areScales(spanOf(p.sun_scale())) && areScales(spanOf(p.emitted_scale())),
      kName, "have a scale out of its domain");
}

void checkError(Check& check, const SectorError& e, std::size_t probes) {
  const double numbers[] = {e.sampling(), e.position_m(), e.visibility(),      e.sky(),        e.sun(),
                            e.emitted(),  e.modes_rms(),  e.modes_worst_row(), e.modes_worst()};
  check.that(within(std::span<const double>(numbers), 0.0, kAny) &&
                 (probes == 0 ? e.sampling_probe() == 0 : e.sampling_probe() < probes),
             "the errors", "have a value out of their domain");
}

}  // namespace welkin::format
