// SPDX-License-Identifier: Apache-2.0
// The parts of cells along walls by shaders/shared/cuts.glsl in floats, from the words that the GPU reads.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>

#include "probes/volume_cuts.h"
#include "shared.h"

#define INLINE inline
#define NUMBER(literal) Number(literal)
#define CUT_BLOCK_NODES static_cast<int>(probes::kBlockWords / probes::kNodeWords)

namespace welkin::f32 {

class CutReader {
  using uint = std::uint32_t;
  struct CutWords {
    uint x, y;
  };

 public:
  CutReader(std::span<const uint> words, const std::array<uint, 2>& mask) : words_(words), mask_(mask) {}

#include "cuts.glsl"   // NOLINT(bugprone-suspicious-include)
#include "doors.glsl"  // NOLINT(bugprone-suspicious-include)

 private:
  uint cutWord(int i) const {
    return words_[static_cast<std::size_t>(i)];
  }
  CutWords cutWords(int i) const {
    return {cutWord(2 * i), cutWord(2 * i + 1)};
  }
  static float cutFloat(uint word) {
    return std::bit_cast<float>(word);
  }
  int cutMask(int axis) const {
    return static_cast<int>(mask_[static_cast<std::size_t>(axis)]);
  }

  std::span<const uint> words_;
  std::array<uint, 2> mask_;
};

}  // namespace welkin::f32

#undef CUT_BLOCK_NODES
#undef NUMBER
#undef INLINE
