// SPDX-License-Identifier: Apache-2.0
#include <numeric>

#include "format/check_parts.h"
#include "format/domain_check.h"

namespace welkin::format {
namespace {

/// Whether every probe has as many lights as `counts` says, in ascending order and below `lights`.
bool areLightsOf(std::span<const std::uint8_t> counts, std::span<const std::uint16_t> light, std::size_t lights) {
  std::size_t next = 0;
  for (const std::uint8_t count : counts) {
    for (std::size_t i = next; i < next + count; ++i)
      if (light[i] >= lights || (i > next && light[i] <= light[i - 1])) return false;
    next += count;
  }
  return true;
}

}  // namespace

void checkLocal(Check& check, const LocalTransfer& l, std::size_t probes) {
  constexpr const char* kName = "the local transfer";
  constexpr std::size_t kNumbers = 4 * 3;
  const auto position = spanOf(l.position());
  const auto counts = spanOf(l.count());
  const auto light = spanOf(l.light());
  const auto radiance = spanOf(l.radiance());
  const std::size_t lights = position.size() / 3;
  const std::size_t transfers = std::accumulate(counts.begin(), counts.end(), std::size_t{0});
  check.that(
      position.size() == 3 * lights && lights <= kMostVirtualLights && within(position, -kFarthest_m, kFarthest_m),
      kName, "must have a position for every light, within 10000 km");
  check.that(counts.size() == probes &&
                 std::all_of(counts.begin(), counts.end(), [](std::uint8_t n) { return n <= kMostLocalLights; }),
             kName, "must have a count for every probe, at most 128");
  if (!check.that(
          light.size() == transfers && spanOf(l.scale()).size() == transfers && radiance.size() == kNumbers * transfers,
          kName, "must have every number of its transfers"))
    return;
  check.that(areLightsOf(counts, light, lights), kName, "must have ascending lights that are there");
  check.that(areScales(spanOf(l.scale())), kName, "has a scale out of its domain");
  for (std::size_t i = 0; i < radiance.size(); ++i)
    check.that(i % kNumbers >= 3 || radiance[i] >= 0, kName, "must have no influence below 0");
  if (l.error() == nullptr) return;
  const LocalError& e = *l.error();
  const double errors[] = {e.sampling(), e.position_m(), e.radiance()};
  const double shares[] = {e.lost(), e.worst_probe()};
  check.that(within(std::span<const double>(errors), 0.0, kAny) && within(std::span<const double>(shares), 0.0, 1.0) &&
                 (probes == 0 ? e.sampling_probe() == 0 : e.sampling_probe() < probes),
             "the errors", "have a value out of their domain");
}

}  // namespace welkin::format
