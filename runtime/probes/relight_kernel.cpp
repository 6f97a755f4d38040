// SPDX-License-Identifier: Apache-2.0
// Relighting with vector instructions. This file compiles once for every kind of them; the best kind that the processor
// has is chosen when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "probes/relight_kernel.cpp"
#include <hwy/foreach_target.h>  // first: it includes this file
#include <hwy/highway.h>

#include <algorithm>
#include <cstring>

#include "probes/packed_probes.h"

HWY_BEFORE_NAMESPACE();
namespace welkin::probes::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A step of 8 or 16 bits of each probe as floats.
template <class D, typename T>
HWY_INLINE hn::Vec<D> floatsAt(D d, const std::byte* steps) {
  const hn::Rebind<T, D> narrow;
  const hn::RebindToSigned<D> wide;
  return hn::ConvertTo(d, hn::PromoteTo(wide, hn::LoadU(narrow, reinterpret_cast<const T*>(steps))));
}

/// Red, green and blue of as many probes as a vector holds.
template <class V>
struct Colour {
  V r, g, b;
};

template <class D>
HWY_INLINE void addTo(D d, Colour<hn::Vec<D>>& sum, hn::Vec<D> number, const float* colour) {
  sum.r = hn::Add(sum.r, hn::Mul(number, hn::Set(d, colour[0])));
  sum.g = hn::Add(sum.g, hn::Mul(number, hn::Set(d, colour[1])));
  sum.b = hn::Add(sum.b, hn::Mul(number, hn::Set(d, colour[2])));
}

/// Light of the eight probes of a block in one direction. `lane` is that of the vector's first probe.
template <class D>
HWY_INLINE Colour<hn::Vec<D>> lit(D d, const std::byte* block, std::size_t modes, const SectorLight& light,
                                  std::size_t direction, std::size_t lane) {
  const auto zero = hn::Zero(d);
  Colour<hn::Vec<D>> sum{zero, zero, zero};
  for (std::size_t k = 0; k < 2; ++k)
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t at = (6 * direction + 3 * k + c) * kBlock + lane;
      auto& channel = c == 0 ? sum.r : c == 1 ? sum.g : sum.b;
      const auto even = floatsAt<D, std::uint8_t>(d, block + BlockLayout::kSky + at);
      const auto side = floatsAt<D, std::int8_t>(d, block + BlockLayout::kSide + at);
      channel = hn::Add(channel, hn::Mul(even, hn::Set(d, light.sky[k][c])));
      channel = hn::Add(channel, hn::Mul(side, hn::Set(d, light.sky[2 + k][c])));
    }
  const auto* scale = reinterpret_cast<const float*>(block + BlockLayout::kScales) + lane;
  const auto of_sky = hn::LoadU(d, scale);
  sum = {hn::Mul(sum.r, of_sky), hn::Mul(sum.g, of_sky), hn::Mul(sum.b, of_sky)};
  if (direction < 3)
    addTo(d, sum, floatsAt<D, std::uint16_t>(d, block + BlockLayout::kVisibility + (direction * kBlock + lane) * 2),
          light.open[direction]);
  const auto of_sun = hn::LoadU(d, scale + kBlock);
  for (std::uint32_t i = 0; i < light.lights; ++i) {
    Colour<hn::Vec<D>> sun{zero, zero, zero};
    const std::byte* step = block + BlockLayout::kSun + direction * modes * kBlock + lane;
    for (std::size_t m = 0; m < modes; ++m)
      addTo(d, sun, floatsAt<D, std::int8_t>(d, step + m * kBlock), light.mode[i][m]);
    sum.r = hn::Add(sum.r, hn::Mul(of_sun, hn::Max(sun.r, zero)));
    sum.g = hn::Add(sum.g, hn::Mul(of_sun, hn::Max(sun.g, zero)));
    sum.b = hn::Add(sum.b, hn::Mul(of_sun, hn::Max(sun.b, zero)));
  }
  return sum;
}

/// Light of the eight probes of a block: [channel][direction][probe].
void relightBlock(const std::byte* block, std::size_t modes, const SectorLight& light, float* out) {
  const hn::CappedTag<float, kBlock> d;
  for (std::size_t lane = 0; lane < kBlock; lane += hn::Lanes(d))
    for (std::size_t b = 0; b < kDirections; ++b) {
      const auto sum = lit(d, block, modes, light, b, lane);
      hn::StoreU(sum.r, d, out + b * kBlock + lane);
      hn::StoreU(sum.g, d, out + (kDirections + b) * kBlock + lane);
      hn::StoreU(sum.b, d, out + (2 * kDirections + b) * kBlock + lane);
    }
}

}  // namespace welkin::probes::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace welkin::probes {

HWY_EXPORT(relightBlock);

void relightProbes(const std::byte* blocks, std::size_t modes, const SectorLight& light, const float* fixed,
                   std::size_t first, std::size_t count, float* out) {
  const auto relight = HWY_DYNAMIC_DISPATCH(relightBlock);
  const std::size_t block_bytes = BlockLayout{modes}.bytes();
  const std::size_t end = first + count;
  float lit[kColours * kBlock];
  for (std::size_t block = first / kBlock; block * kBlock < end; ++block) {
    relight(blocks + block * block_bytes, modes, light, lit);
    const std::size_t from = std::max(block * kBlock, first);
    const std::size_t to = std::min((block + 1) * kBlock, end);
    for (std::size_t p = from; p < to; ++p)
      for (std::size_t i = 0; i < kColours; ++i) {
        const float always = fixed == nullptr ? 0.0F : light.local * fixed[p * kColours + i];
        out[p * kColours + i] = lit[i * kBlock + p % kBlock] + always;
      }
  }
}

}  // namespace welkin::probes
#endif
