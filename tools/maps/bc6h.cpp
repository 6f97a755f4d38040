// SPDX-License-Identifier: Apache-2.0
#include "maps/bc6h.h"

#include <Imath/half.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace welkin::maps {
namespace {

constexpr std::size_t kTexels = 16;
constexpr std::array<int, 16> kWeight = {0, 4, 9, 13, 17, 21, 26, 30, 34, 38, 43, 47, 51, 55, 60, 64};

/// A colour on the scale of 16 bits on which blocks interpolate; a half's bits are 31/64 of it.
using Colour = std::array<double, 3>;
using Codes = std::array<int, 3>;

/// A mode with one pair of endpoints: bits of the first, and of the second or of its difference to the first.
struct Mode {
  unsigned code;
  int bits, second_bits;
  bool difference;
};
constexpr Mode kModes[] = {{3, 10, 10, false}, {7, 11, 9, true}, {11, 12, 8, true}, {15, 16, 4, true}};

/// Value of an endpoint's code on the scale of 16 bits.
int valueOf(int code, int bits) {
  if (bits >= 15 || code == 0) return code;
  if (code == (1 << bits) - 1) return 0xffff;
  return ((code << 16) + 0x8000) >> bits;
}

int codeOf(double value, int bits) {
  const double step = std::ldexp(1.0, 16 - bits);
  const double code = bits >= 15 ? std::floor(value + 0.5) : std::floor(value / step);
  return static_cast<int>(std::clamp(code, 0.0, std::ldexp(1.0, bits) - 1.0));
}

/// Bits of the half that a decoder makes of two endpoints.
int halfOf(int first, int second, int weight) {
  return ((first * (64 - weight) + second * weight + 32) >> 6) * 31 >> 6;
}

/// A block before its bits are written.
struct Candidate {
  Mode mode{};
  Codes first{}, second{};
  std::array<int, kTexels> index{};
  double error = std::numeric_limits<double>::infinity();
};

/// The indices with the least error. The first texel's has no upper bit.
void chooseIndices(const std::array<Codes, kTexels>& half, Candidate& candidate) {
  std::array<Codes, 16> palette{};
  for (std::size_t c = 0; c < 3; ++c) {
    const int first = valueOf(candidate.first[c], candidate.mode.bits);
    const int second = valueOf(candidate.second[c], candidate.mode.bits);
    for (std::size_t i = 0; i < 16; ++i) palette[i][c] = halfOf(first, second, kWeight[i]);
  }
  candidate.error = 0.0;
  for (std::size_t texel = 0; texel < kTexels; ++texel) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < (texel == 0 ? 8U : 16U); ++i) {
      double error = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double difference = palette[i][c] - half[texel][c];
        error += difference * difference;
      }
      if (error < least) {
        least = error;
        candidate.index[texel] = static_cast<int>(i);
      }
    }
    candidate.error += least;
  }
}

/// The block of two endpoints in a mode; its error is infinite where the mode cannot hold their difference.
Candidate tryMode(const std::array<Codes, kTexels>& half, const Mode& mode, const Colour& first, const Colour& second) {
  Candidate candidate;
  candidate.mode = mode;
  for (std::size_t c = 0; c < 3; ++c) {
    candidate.first[c] = codeOf(first[c], mode.bits);
    candidate.second[c] = codeOf(second[c], mode.bits);
    const int difference = candidate.second[c] - candidate.first[c];
    const int most = 1 << (mode.second_bits - 1);
    if (mode.difference && (difference < -most || difference >= most)) return candidate;
  }
  chooseIndices(half, candidate);
  return candidate;
}

/// Ends of the line through the colours along their direction of greatest variance.
std::array<Colour, 2> endsOf(const std::array<Colour, kTexels>& colour) {
  Colour mean{}, low = colour[0], high = colour[0];
  for (const Colour& one : colour)
    for (std::size_t c = 0; c < 3; ++c) {
      mean[c] += one[c] / kTexels;
      low[c] = std::min(low[c], one[c]);
      high[c] = std::max(high[c], one[c]);
    }
  double covariance[3][3] = {};
  for (const Colour& one : colour)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) covariance[i][j] += (one[i] - mean[i]) * (one[j] - mean[j]);
  // Powers of the matrix turn any vector towards that direction. The column of the largest variance is one with a part
  // along it.
  const std::size_t widest = static_cast<std::size_t>(std::max_element(low.begin(), low.end(),
                                                                       [&](const double& a, const double& b) {
                                                                         const auto i = &a - low.data(),
                                                                                    j = &b - low.data();
                                                                         return covariance[i][i] < covariance[j][j];
                                                                       }) -
                                                      low.begin());
  Colour axis = {covariance[0][widest], covariance[1][widest], covariance[2][widest]};
  for (int power = 0; power < 8; ++power) {
    Colour next{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) next[i] += covariance[i][j] * axis[j];
    const double largest = std::max({std::abs(next[0]), std::abs(next[1]), std::abs(next[2])});
    if (!(largest > 0.0)) return {mean, mean};
    for (std::size_t c = 0; c < 3; ++c) axis[c] = next[c] / largest;
  }
  const double square = axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2];
  double least = 0.0, most = 0.0;
  for (const Colour& one : colour) {
    double along = 0.0;
    for (std::size_t c = 0; c < 3; ++c) along += (one[c] - mean[c]) * axis[c] / square;
    least = std::min(least, along);
    most = std::max(most, along);
  }
  std::array<Colour, 2> ends{};
  for (std::size_t c = 0; c < 3; ++c) {
    ends[0][c] = std::clamp(mean[c] + least * axis[c], 0.0, 65535.0);
    ends[1][c] = std::clamp(mean[c] + most * axis[c], 0.0, 65535.0);
  }
  return ends;
}

/// The ends with the least squares for given indices; the old ones where all indices are equal.
std::array<Colour, 2> refined(const std::array<Colour, kTexels>& colour, const Candidate& candidate,
                              const std::array<Colour, 2>& old) {
  double aa = 0.0, ab = 0.0, bb = 0.0;
  Colour a{}, b{};
  for (std::size_t texel = 0; texel < kTexels; ++texel) {
    const double second = kWeight[static_cast<std::size_t>(candidate.index[texel])] / 64.0, first = 1.0 - second;
    aa += first * first;
    ab += first * second;
    bb += second * second;
    for (std::size_t c = 0; c < 3; ++c) {
      a[c] += first * colour[texel][c];
      b[c] += second * colour[texel][c];
    }
  }
  const double determinant = aa * bb - ab * ab;
  if (!(determinant > 1e-6)) return old;
  std::array<Colour, 2> ends{};
  for (std::size_t c = 0; c < 3; ++c) {
    ends[0][c] = std::clamp((a[c] * bb - b[c] * ab) / determinant, 0.0, 65535.0);
    ends[1][c] = std::clamp((b[c] * aa - a[c] * ab) / determinant, 0.0, 65535.0);
  }
  return ends;
}

/// Writes bits from the lowest of the first byte on.
class BitWriter {
 public:
  explicit BitWriter(unsigned char* bytes) : bytes_(bytes) { std::fill_n(bytes, kBc6hBytes, std::uint8_t{0}); }
  void write(int value, int bits) {
    for (int bit = 0; bit < bits; ++bit, ++at_)
      bytes_[at_ / 8] = static_cast<unsigned char>(bytes_[at_ / 8] | (value >> bit & 1) << (at_ % 8));
  }

 private:
  unsigned char* bytes_;
  std::size_t at_ = 0;
};

void writeBlock(const Candidate& block, unsigned char* bytes) {
  BitWriter writer(bytes);
  writer.write(static_cast<int>(block.mode.code), 5);
  for (std::size_t c = 0; c < 3; ++c) writer.write(block.first[c], 10);
  for (std::size_t c = 0; c < 3; ++c) {
    writer.write(block.second[c] - (block.mode.difference ? block.first[c] : 0), block.mode.second_bits);
    for (int bit = block.mode.bits - 1; bit >= 10; --bit) writer.write(block.first[c] >> bit, 1);  // highest first
  }
  for (std::size_t texel = 0; texel < kTexels; ++texel) writer.write(block.index[texel], texel == 0 ? 3 : 4);
}

}  // namespace

std::size_t encodeBc6h(const Bc6hTexels& texels, unsigned char* block) {
  constexpr float kLargest = 65504.0F;
  std::size_t saturated = 0;
  std::array<Codes, kTexels> half{};
  std::array<Colour, kTexels> colour{};
  for (std::size_t i = 0; i < kTexels; ++i)
    for (std::size_t c = 0; c < 3; ++c) {
      const float value = texels[i][c];
      saturated += value > kLargest ? 1U : 0U;
      half[i][c] = value > 0.0F ? Imath::half(std::min(value, kLargest)).bits() : 0;
      colour[i][c] = std::min((half[i][c] + 0.5) * 64.0 / 31.0, 65535.0);  // the middle of what decodes to the half
      if (half[i][c] == 0) colour[i][c] = 0.0;
    }
  Candidate best;
  std::array<Colour, 2> ends = endsOf(colour);
  for (int round = 0; round < 3; ++round) {
    Candidate best_of_round;
    for (const Mode& mode : kModes)
      for (const Candidate& candidate : {tryMode(half, mode, ends[0], ends[1]), tryMode(half, mode, ends[1], ends[0])})
        if (candidate.error < best_of_round.error) best_of_round = candidate;
    if (best_of_round.error < best.error) best = best_of_round;
    ends = refined(colour, best_of_round, ends);
  }
  writeBlock(best, block);
  return saturated;
}

}  // namespace welkin::maps
