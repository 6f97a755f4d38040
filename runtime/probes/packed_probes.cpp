// SPDX-License-Identifier: Apache-2.0
#include "probes/packed_probes.h"

#include <algorithm>
#include <bit>
#include <cstring>

#include "format/domain_check.h"

namespace welkin::probes {
namespace {

using format::spanOf;

/// The scale whose upper 16 bits these are, at most kMostScale.
float scaleOf(std::uint16_t bits) {
  return std::min(std::bit_cast<float>(std::uint32_t{bits} << 16), kMostScale);
}

/// Spreads the numbers of each probe, `count` of them side by side in `from`, over its lane of the blocks.
template <typename T>
void spread(std::span<const T> from, std::size_t count, std::size_t at, std::size_t block_bytes, std::byte* blocks) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    const std::size_t probe = i / count;
    std::byte* block = blocks + probe / kBlock * block_bytes + at;
    std::memcpy(block + (i % count * kBlock + probe % kBlock) * sizeof(T), &from[i], sizeof(T));
  }
}

}  // namespace

bool packProbes(const format::Probes& probes, const core::HostMemory& memory, core::HostArray<std::byte>& blocks) {
  const std::size_t count = spanOf(probes.sky_scale()).size();
  const BlockLayout layout{spanOf(probes.mode_scale()).size()};
  const std::size_t bytes = (count + kBlock - 1) / kBlock * layout.bytes();
  if (bytes == 0) return true;
  if (!blocks.allocate(memory, bytes)) return false;
  std::fill_n(blocks.get(), bytes, std::byte{0});
  for (std::size_t p = 0; p < count; ++p) {
    std::byte* block = blocks.get() + p / kBlock * layout.bytes() + p % kBlock * sizeof(float);
    const float sky = scaleOf(spanOf(probes.sky_scale())[p]);
    std::memcpy(block, &sky, sizeof sky);
    if (layout.modes == 0) continue;
    const float sun = scaleOf(spanOf(probes.sun_scale())[p]);
    std::memcpy(block + kBlock * sizeof(float), &sun, sizeof sun);
  }
  spread(spanOf(probes.visibility()), 3, BlockLayout::kVisibility, layout.bytes(), blocks.get());
  spread(spanOf(probes.sky()), 24, BlockLayout::kSky, layout.bytes(), blocks.get());
  spread(spanOf(probes.sky_side()), 24, BlockLayout::kSide, layout.bytes(), blocks.get());
  if (layout.modes > 0)
    spread(spanOf(probes.sun()), kDirections * layout.modes, BlockLayout::kSun, layout.bytes(), blocks.get());
  return true;
}

bool unpackEmitted(const format::Probes& probes, const core::HostMemory& memory, core::HostArray<float>& light) {
  const auto scale = spanOf(probes.emitted_scale());
  if (scale.empty()) return true;
  if (!light.allocate(memory, kColours * scale.size())) return false;
  std::fill_n(light.get(), kColours * scale.size(), 0.0F);
  addEmitted(probes, light.get());
  return true;
}

void addEmitted(const format::Probes& probes, float* light) {
  const auto scale = spanOf(probes.emitted_scale());
  const auto emitted = spanOf(probes.emitted());
  for (std::size_t i = 0; i < emitted.size(); ++i) {
    const std::size_t probe = i / kColours, direction = i % kColours / kChannels, channel = i % kChannels;
    light[probe * kColours + channel * kDirections + direction] +=
        static_cast<float>(double{scaleOf(scale[probe])} * emitted[i] / 255.0);
  }
}

}  // namespace welkin::probes
