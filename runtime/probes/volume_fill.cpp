// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstring>

#include "format/half.h"
#include "probes/volume.h"

namespace welkin::probes {
namespace {

constexpr int kSide = format::kCellsAcross;

/// Writes a texel's words at an index.
template <typename Word>
void write(WelkinVolume& volume, std::size_t at, const TexelWords& words) {
  for (std::size_t c = 0; c < volume.channels; ++c)
    reinterpret_cast<Word*>(volume.texels[c].get())[at] = static_cast<Word>(words[c]);
}

/// Row of a sector's grid for a height; those below and above it have the light of its ends.
int rowOf(const format::GridView& grid, double y) {
  const double row = std::floor((y - grid.low_y) / grid.cell_height_m);
  return static_cast<int>(std::clamp(row, 0.0, double{kSide - 1}));
}

/// The probe of a cell, for a point in it; kNoProbe in a sector without probes.
std::uint8_t probeOf(const WelkinSector& sector, std::size_t cell, double y, int x, int z) {
  const std::uint8_t probe = sector.filled[cell];
  if (sector.cut.get() == nullptr || (sector.cut.get()[cell / 64] >> (cell % 64) & 1) == 0) return probe;
  const auto middle = [](int i) { return static_cast<float>((i + 0.5) * format::kCellWidth_m); };
  const format::FromCorner p{middle(x), static_cast<float>(y), middle(z)};
  const std::uint8_t own = format::leafOfCell(sector.grid.cuts, cell, probe, p).probe;
  return own == format::kNoProbe ? probe : own;
}

template <typename Word>
void fill(WelkinVolume& volume, const WelkinLevel& level, const Cells& low, const Cells& high) {
  const auto remainder = [&](std::int64_t cell, std::size_t axis) {
    const std::int64_t n = volume.count[axis];
    return static_cast<std::size_t>(((cell % n) + n) % n);
  };
  const auto floorSide = [](std::int64_t cell) { return (cell >= 0 ? cell : cell - kSide + 1) / kSide; };
  for (std::int64_t z = low[2]; z < high[2]; ++z)
    for (std::int64_t x = low[0]; x < high[0];) {
      const std::int64_t sx = floorSide(x), sz = floorSide(z);
      const std::int64_t end = std::min(high[0], (sx + 1) * kSide);
      const WelkinSector* sector = residentAt(level, static_cast<std::int32_t>(sx), static_cast<std::int32_t>(sz));
      for (std::int64_t y = low[1]; y < high[1]; ++y) {
        const std::size_t row = volume.count[0] * (remainder(y, 1) + volume.count[1] * remainder(z, 2));
        const double middle = (static_cast<double>(y) + 0.5) * volume.texel_m[1];
        const std::size_t cells = sector == nullptr
                                      ? 0
                                      : static_cast<std::size_t>(kSide * (rowOf(sector->grid, middle) +
                                                                          kSide * static_cast<int>(z - sz * kSide)));
        std::size_t in_row = remainder(x, 0);
        for (std::int64_t i = x; i < end; ++i) {
          const std::size_t at = row + in_row;
          in_row = in_row + 1 == volume.count[0] ? 0 : in_row + 1;
          const auto column = static_cast<std::size_t>(i - sx * kSide);
          const std::uint8_t probe = sector == nullptr
                                         ? format::kNoProbe
                                         : probeOf(*sector, cells + column, middle, static_cast<int>(column),
                                                   static_cast<int>(z - sz * kSide));
          write<Word>(volume, at, probe == format::kNoProbe ? volume.open : texelOf(volume, sector, probe));
        }
      }
      x = end;
    }
}

}  // namespace

TexelWords packTexel(const float* light, WelkinVolumeFormat format, float scale) {
  TexelWords words{};
  for (std::size_t c = 0; c < kChannels; ++c)
    for (std::size_t b = 0; b < kDirections; ++b) {
      const float value = light[c * kDirections + b] / scale;
      if (format == WELKIN_VOLUME_RGBA16F)
        words[c] |= std::uint64_t{format::halfFromFloat(value)} << (16 * b);
      else
        words[c] |= static_cast<std::uint64_t>((value > 0.0F ? std::min(value, 1.0F) : 0.0F) * 255.0F + 0.5F)
                    << (8 * b);
    }
  return words;
}

std::array<float, kDirections> unpackTexel(std::uint64_t word, WelkinVolumeFormat format, float scale) {
  std::array<float, kDirections> numbers{};
  for (std::size_t b = 0; b < kDirections; ++b)
    numbers[b] =
        scale * (format == WELKIN_VOLUME_RGBA16F ? format::floatFromHalf(static_cast<std::uint16_t>(word >> (16 * b)))
                                                 : static_cast<float>(word >> (8 * b) & 0xffU) / 255.0F);
  return numbers;
}

std::uint32_t slotOf(const WelkinVolume& volume, std::int32_t x, std::int32_t z) {
  const auto along = [&](std::int32_t sector, std::size_t axis) {
    const std::int64_t n = volume.slots[axis];
    return static_cast<std::uint32_t>((sector % n + n) % n);
  };
  return along(x, 0) + volume.slots[0] * along(z, 1);
}

TexelWords texelOf(const WelkinVolume& volume, const WelkinSector* sector, std::uint32_t probe) {
  if (volume.format != WELKIN_VOLUME_DEVICE) return sector == nullptr ? TexelWords{} : sector->packed.get()[probe];
  return {sector == nullptr ? kDarkTexel : kFirstTexel + kSlotProbes * slotOf(volume, sector->x, sector->z) + probe};
}

void fillCells(WelkinVolume& volume, const WelkinLevel& level, const Cells& low, const Cells& high) {
  if (volume.format == WELKIN_VOLUME_RGBA16F)
    fill<std::uint64_t>(volume, level, low, high);
  else
    fill<std::uint32_t>(volume, level, low, high);
}

void copyFirstSlice(WelkinVolume& volume) {
  const std::size_t bytes = volume.texel_bytes * volume.count[0] * volume.count[1];
  for (std::size_t c = 0; c < volume.channels; ++c)
    std::memcpy(volume.texels[c].get() + bytes * volume.count[2], volume.texels[c].get(), bytes);
}

void fillBricks(WelkinVolume& volume, std::uint32_t first, std::uint32_t count) {
  const VolumeCuts& cuts = volume.cuts;
  for (std::uint32_t b = first * cuts.perLayer(); b < (first + count) * cuts.perLayer(); ++b) {
    const BrickProbes* probes = cuts.probesOf(b);
    if (probes == nullptr) continue;
    const std::uint32_t in_layer = b % cuts.perLayer(), across = cuts.across()[0];
    const std::size_t x = 3 * (in_layer % across), y = 3 * (in_layer / across);
    const std::size_t z = volume.count[2] + 1 + 3 * (b / cuts.perLayer());
    for (std::size_t i = 0; i < probes->size(); ++i) {
      const std::size_t at = x + i % 3 + volume.count[0] * (y + i / 3 % 3 + volume.count[1] * (z + i / 9));
      const TexelWords words = texelOf(volume, cuts.holderOf((*probes)[i]), (*probes)[i] % kSlotProbes);
      if (volume.format == WELKIN_VOLUME_RGBA16F)
        write<std::uint64_t>(volume, at, words);
      else
        write<std::uint32_t>(volume, at, words);
    }
  }
}

}  // namespace welkin::probes
