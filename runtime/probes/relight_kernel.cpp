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

/// Light of the sky on the eight probes of a block in one direction. `lane` is that of the vector's first probe.
template <class D>
HWY_INLINE Colour<hn::Vec<D>> skyOf(D d, const std::byte* block, const SectorLight& light, std::size_t direction,
                                    std::size_t lane) {
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
  const auto of_sky = hn::LoadU(d, reinterpret_cast<const float*>(block + BlockLayout::kScales) + lane);
  sum = {hn::Mul(sum.r, of_sky), hn::Mul(sum.g, of_sky), hn::Mul(sum.b, of_sky)};
  if (direction < 3)
    addTo(d, sum, floatsAt<D, std::uint16_t>(d, block + BlockLayout::kVisibility + (direction * kBlock + lane) * 2),
          light.open[direction]);
  return sum;
}

/// Adds a light's bounced light, which is never negative.
template <class D>
HWY_INLINE void addSun(D d, Colour<hn::Vec<D>>& sum, hn::Vec<D> scale, const Colour<hn::Vec<D>>& sun) {
  const auto zero = hn::Zero(d);
  sum.r = hn::Add(sum.r, hn::Mul(scale, hn::Max(sun.r, zero)));
  sum.g = hn::Add(sum.g, hn::Mul(scale, hn::Max(sun.g, zero)));
  sum.b = hn::Add(sum.b, hn::Mul(scale, hn::Max(sun.b, zero)));
}

/// Adds the bounced light of sun and moon in two directions, of `kLights` of them. Each number is read once.
template <int kLights, class D>
HWY_INLINE void addSuns(D d, const std::byte* block, std::size_t modes, const SectorLight& light, std::size_t direction,
                        std::size_t lane, Colour<hn::Vec<D>>& first, Colour<hn::Vec<D>>& second) {
  const auto zero = hn::Zero(d);
  const Colour<hn::Vec<D>> dark{zero, zero, zero};
  Colour<hn::Vec<D>> a0 = dark, a1 = dark, b0 = dark, b1 = dark;  // direction, light
  const std::byte* step_a = block + BlockLayout::kSun + direction * modes * kBlock + lane;
  const std::byte* step_b = step_a + modes * kBlock;
  for (std::size_t m = 0; m < modes; ++m) {
    const auto a = floatsAt<D, std::int8_t>(d, step_a + m * kBlock);
    const auto b = floatsAt<D, std::int8_t>(d, step_b + m * kBlock);
    addTo(d, a0, a, light.mode[0][m]);
    addTo(d, b0, b, light.mode[0][m]);
    if constexpr (kLights > 1) {
      addTo(d, a1, a, light.mode[1][m]);
      addTo(d, b1, b, light.mode[1][m]);
    }
  }
  const auto scale = hn::LoadU(d, reinterpret_cast<const float*>(block + BlockLayout::kScales) + kBlock + lane);
  addSun(d, first, scale, a0);
  addSun(d, second, scale, b0);
  if constexpr (kLights > 1) {
    addSun(d, first, scale, a1);
    addSun(d, second, scale, b1);
  }
}

/// Light of the eight probes of a block: [channel][probe][direction].
void relightBlock(const std::byte* block, std::size_t modes, const SectorLight& light, float* out) {
  const hn::CappedTag<float, kBlock> d;
  HWY_ALIGN float row[kChannels][kDirections][kBlock];
  for (std::size_t lane = 0; lane < kBlock; lane += hn::Lanes(d)) {
    for (std::size_t b = 0; b < kDirections; b += 2) {
      auto first = skyOf(d, block, light, b, lane), second = skyOf(d, block, light, b + 1, lane);
      if (light.lights == 1) addSuns<1>(d, block, modes, light, b, lane, first, second);
      if (light.lights == 2) addSuns<2>(d, block, modes, light, b, lane, first, second);
      hn::StoreU(first.r, d, row[0][b] + lane);
      hn::StoreU(first.g, d, row[1][b] + lane);
      hn::StoreU(first.b, d, row[2][b] + lane);
      hn::StoreU(second.r, d, row[0][b + 1] + lane);
      hn::StoreU(second.g, d, row[1][b + 1] + lane);
      hn::StoreU(second.b, d, row[2][b + 1] + lane);
    }
    for (std::size_t c = 0; c < kChannels; ++c)
      hn::StoreInterleaved4(hn::LoadU(d, row[c][0] + lane), hn::LoadU(d, row[c][1] + lane),
                            hn::LoadU(d, row[c][2] + lane), hn::LoadU(d, row[c][3] + lane), d,
                            out + (c * kBlock + lane) * kDirections);
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
  using Directions [[gnu::vector_size(kDirections * sizeof(float))]] = float;
  HWY_ALIGN Directions lit[kChannels][kBlock];
  for (std::size_t block = first / kBlock; block * kBlock < end; ++block) {
    relight(blocks + block * block_bytes, modes, light, reinterpret_cast<float*>(lit));
    const std::size_t from = std::max(block * kBlock, first);
    const std::size_t to = std::min((block + 1) * kBlock, end);
    for (std::size_t p = from; p < to; ++p)
      for (std::size_t c = 0; c < kChannels; ++c) {
        Directions always{};
        const std::size_t at = p * kColours + c * kDirections;
        if (fixed != nullptr) std::memcpy(&always, fixed + at, sizeof always);
        always = lit[c][p % kBlock] + light.local * always;
        std::memcpy(out + at, &always, sizeof always);
      }
  }
}

}  // namespace welkin::probes
#endif
