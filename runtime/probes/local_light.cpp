// SPDX-License-Identifier: Apache-2.0
#include "probes/local_light.h"

#include <algorithm>
#include <bit>

#include "format/domain_check.h"
#include "probes/level.h"
#include "shared.h"

namespace welkin::probes {
namespace {

using format::spanOf;

constexpr std::size_t kTransferNumbers = 4 * kChannels;  // coefficient, channel
constexpr float kMostFixed = 1e18F;                      // so that no factor makes it infinite
constexpr std::size_t kMostTransfers = 255 * 128;        // probes, lights of each: local_check.cpp

static_assert(kTransferNumbers == kColours && kMostTransfers < 65536);

/// Adds a light's radiance to the probes: [probe][coefficient][channel].
void addRadiance(const WelkinSector& sector, std::uint32_t light, float* radiance) {
  const format::LocalTransfer& local = *sector.file->local();
  const std::uint16_t* scale = local.scale()->data();
  const std::int8_t* number = local.radiance()->data();
  const LocalTransfers& by_light = sector.transfers;
  const float* colour = sector.lights.light.get()[light].colour;
  for (std::size_t i = by_light.start.get()[light]; i < by_light.start.get()[light + 1]; ++i) {
    const std::size_t t = by_light.transfer.get()[i];
    const float step = std::min(std::bit_cast<float>(std::uint32_t{scale[t]} << 16), kMostScale) / 127.0F;
    const float of_step[kChannels] = {colour[0] * step, colour[1] * step, colour[2] * step};
    float* sum = radiance + by_light.probe.get()[i] * kTransferNumbers;
    const std::int8_t* row = number + kTransferNumbers * t;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t c = 0; c < kChannels; ++c)
        sum[k * kChannels + c] += of_step[c] * static_cast<float>(row[k * kChannels + c]);
  }
}

/// Turns a probe's radiance into irradiance by direction: [channel][direction].
void toIrradiance(const float (*weight)[4], float* light) {
  float radiance[kTransferNumbers];
  std::copy_n(light, kTransferNumbers, radiance);
  for (std::size_t c = 0; c < kChannels; ++c)
    for (std::size_t b = 0; b < kDirections; ++b) {
      float sum = 0.0F;
      for (std::size_t k = 0; k < 4; ++k) sum += weight[b][k] * radiance[k * kChannels + c];
      light[c * kDirections + b] = std::clamp(sum, -kMostFixed, kMostFixed);
    }
}

}  // namespace

bool openTransfers(WelkinSector& sector) {
  if (sector.lights.count == 0) return true;
  const format::LocalTransfer& local = *sector.file->local();
  const auto counts = spanOf(local.count());
  const auto light = spanOf(local.light());
  LocalTransfers& by_light = sector.transfers;
  by_light.count = static_cast<std::uint32_t>(light.size());
  const std::size_t lights = sector.lights.count;
  if (!by_light.start.allocate(sector.memory, lights + 1)) return false;
  std::uint16_t* start = by_light.start.get();
  std::fill_n(start, lights + 1, std::uint16_t{0});
  if (light.empty()) return true;
  if (!by_light.probe.allocate(sector.memory, light.size()) ||
      !by_light.transfer.allocate(sector.memory, light.size()) ||
      (sector.fixed.get() == nullptr && !sector.fixed.allocate(sector.memory, kColours * sector.probes)))
    return false;
  for (const std::uint16_t l : light) ++start[l];
  std::uint16_t end = 0;
  for (std::size_t l = 0; l <= lights; ++l) start[l] = end = static_cast<std::uint16_t>(end + start[l]);
  for (std::size_t p = counts.size(), t = light.size(); p-- > 0;)  // backwards, so that probes ascend
    for (std::uint8_t i = 0; i < counts[p]; ++i) {
      const std::uint16_t at = --start[light[--t]];
      by_light.probe.get()[at] = static_cast<std::uint8_t>(p);
      by_light.transfer.get()[at] = static_cast<std::uint16_t>(t);
    }
  lightLocally(sector);
  return true;
}

std::size_t localBytes(const WelkinSector& sector) {
  if (sector.lights.count == 0) return 0;
  return sector.lights.count * sizeof(VirtualLight) + (sector.lights.count + 1) * sizeof(std::uint16_t) +
         sector.transfers.count * (sizeof(std::uint8_t) + sizeof(std::uint16_t));
}

void lightLocally(WelkinSector& sector) {
  if (sector.transfers.count == 0) return;
  sector.complete = sector.pass = 0;  // a pass that has begun goes on, and another one follows
  ++sector.fixed_changes;
  float* fixed = sector.fixed.get();
  const f64::TransferBasis basis = f64::transferBasis();
  float weight[kDirections][4];
  for (std::size_t b = 0; b < kDirections; ++b) {
    const f64::ShBasis at = f64::shBasis(basis.v[b]);
    for (std::size_t k = 0; k < 4; ++k) weight[b][k] = static_cast<float>(f64::cosineLobe(k == 0 ? 0 : 1) * at.v[k]);
  }
  std::fill_n(fixed, kColours * sector.probes, 0.0F);
  sector.lights.is_lit = false;
  for (std::uint32_t l = 0; l < sector.lights.count; ++l) {
    const float* colour = sector.lights.light.get()[l].colour;
    if (!(colour[0] > 0.0F || colour[1] > 0.0F || colour[2] > 0.0F)) continue;
    addRadiance(sector, l, fixed);
    sector.lights.is_lit = true;
  }
  for (std::size_t p = 0; p < sector.probes; ++p) toIrradiance(weight, fixed + kColours * p);
  addEmitted(*sector.file->probes(), fixed);
}

}  // namespace welkin::probes
