// SPDX-License-Identifier: Apache-2.0
#include "vulkan/mips.h"

#include <algorithm>
#include <memory>
#include <new>

namespace welkin::vulkan {
namespace {

/// The texels of the larger mip that one texel of the smaller mip covers along an axis, at most three, and their
/// shares.
struct Cover {
  uint32_t first = 0;
  uint32_t count = 0;
  float share[3] = {};

  Cover(uint32_t from, uint32_t to, uint32_t i) {
    const float width = static_cast<float>(from) / static_cast<float>(to);
    const float low = static_cast<float>(i) * width;
    const float high = std::min(low + width, static_cast<float>(from));
    first = std::min(static_cast<uint32_t>(low), from - 1);
    for (uint32_t j = first; count < 3 && j < from; ++j) {
      const float inside = std::min(high, static_cast<float>(j + 1)) - std::max(low, static_cast<float>(j));
      if (!(inside > 0.0F)) break;
      share[count++] = inside / width;
    }
  }
};

/// Reduces a face's RGB from `from` x `from` to `to` x `to` texels. May work in place: a texel only reads texels at or
/// after its own place.
void halve(const float* face, uint32_t from, float* smaller, uint32_t to) {
  for (uint32_t row = 0; row < to; ++row) {
    const Cover rows(from, to, row);
    for (uint32_t column = 0; column < to; ++column) {
      const Cover columns(from, to, column);
      float sum[3] = {};
      for (uint32_t j = 0; j < rows.count; ++j)
        for (uint32_t i = 0; i < columns.count; ++i) {
          const float share = rows.share[j] * columns.share[i];
          const float* texel = face + 3 * (std::size_t{rows.first + j} * from + columns.first + i);
          for (int c = 0; c < 3; ++c) sum[c] += share * texel[c];
        }
      std::copy_n(sum, 3, smaller + 3 * (std::size_t{row} * to + column));
    }
  }
}

}  // namespace

bool makeMips(format::CubemapFormat format, uint32_t edge, const unsigned char* texels, unsigned char* mips) {
  const std::size_t bytes = format::texelBytes(format);
  const std::size_t area = std::size_t{edge} * edge;
  const std::unique_ptr<float[]> face(new (std::nothrow) float[3 * area]);
  if (face == nullptr) return false;
  for (std::size_t f = 0; f < 6; ++f) {
    for (std::size_t i = 0; i < area; ++i) {
      float rgb[3];
      format::decodeTexel(format, texels + (f * area + i) * bytes, rgb);
      std::copy_n(rgb, 3, face.get() + 3 * i);
    }
    unsigned char* mip = mips;
    for (uint32_t from = edge; from > 1;) {
      const uint32_t to = from / 2;
      halve(face.get(), from, face.get(), to);
      const std::size_t smaller = std::size_t{to} * to;
      unsigned char* out = mip + f * smaller * bytes;
      for (std::size_t i = 0; i < smaller; ++i) {
        const float rgb[3] = {face[3 * i], face[3 * i + 1], face[3 * i + 2]};
        format::encodeTexel(format, rgb, out + i * bytes);
      }
      mip += format::bytesOfCubemaps(format, to);
      from = to;
    }
  }
  return true;
}

}  // namespace welkin::vulkan
