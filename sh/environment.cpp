// SPDX-License-Identifier: Apache-2.0
#include "sh/environment.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "sh/basis.h"
#include "sh/cube_weights.h"
#include "sh/rotation.h"

namespace welkin::sh {
namespace {

using det::Number3;
using Pair [[gnu::vector_size(2 * sizeof(double))]] = double;  // every x86-64 adds this in one instruction

constexpr int kRowsAtOnce = 8;

/// Sum of weight x value over `pairs` pairs, for each of three channels.
Number3 weightedSum(const double* weight, const double* const (&channel)[3], std::size_t pairs) {
  const auto at = [](const double* p, std::size_t i) {
    Pair pair;
    std::memcpy(&pair, p + 2 * i, sizeof pair);
    return pair;
  };
  Pair sum[3] = {};
  for (std::size_t i = 0; i < pairs; ++i) {
    const Pair w = at(weight, i);
    for (int c = 0; c < 3; ++c) sum[c] += w * at(channel[c], i);
  }
  return {sum[0][0] + sum[0][1], sum[1][0] + sum[1][1], sum[2][0] + sum[2][1]};
}

/// The four quarters of a face that mirror each other, as their sums and differences. These multiply the weights that
/// are even or odd in x and in y.
class FoldedRow {
 public:
  explicit FoldedRow(std::size_t pairs)
      : pairs_(pairs), storage_(24 * pairs), sum_(12 * pairs), difference_(12 * pairs) {}

  void fold(const CubeFace& face, int size, int row) {
    const float* const top = face.rgb + row * face.row;
    const float* const bottom = face.rgb + (size - 1 - row) * face.row;
    const std::size_t floats = 3 * static_cast<std::size_t>(size);
    if (2 * row + 1 == size)  // the middle row of an odd size has no mirror image
      for (std::size_t i = 0; i < floats; ++i) sum_[i] = difference_[i] = double{top[i]};
    else
      for (std::size_t i = 0; i < floats; ++i) {
        sum_[i] = double{top[i]} + double{bottom[i]};
        difference_[i] = double{top[i]} - double{bottom[i]};
      }
    for (int c = 0; c < 3; ++c) {
      foldColumns(sum_.data() + c, size, plane({false, false}, c), plane({true, false}, c));
      foldColumns(difference_.data() + c, size, plane({false, true}, c), plane({true, true}, c));
    }
  }

  double* plane(Parity parity, int channel) {
    const auto index = static_cast<std::size_t>((parity.odd_x ? 1 : 0) + (parity.odd_y ? 2 : 0)) * 3;
    return storage_.data() + (index + static_cast<std::size_t>(channel)) * 2 * pairs_;
  }

  static void foldColumns(const double* from, int size, double* even, double* odd) {
    const double* mirrored = from + std::ptrdiff_t{3} * (size - 1);
    const int pairs = size / 2;
    for (int i = 0; i < pairs; ++i, from += 3, mirrored -= 3) {
      even[i] = *from + *mirrored;
      odd[i] = *from - *mirrored;
    }
    if (size % 2 == 1) even[pairs] = odd[pairs] = *from;  // the middle column has no mirror image either
  }

  std::size_t pairs_;
  std::vector<double> storage_, sum_, difference_;
};

}  // namespace

std::vector<Number3> projectCube(std::span<const CubeFace, 6> faces, int size, TexelRule rule, int bands) {
  const CubeWeights weights(size, rule, bands);
  const auto count = static_cast<std::size_t>(coefficientCount(bands));
  const auto pairs = static_cast<std::size_t>(weights.half() + 1) / 2;
  const int blocks = (weights.half() + kRowsAtOnce - 1) / kRowsAtOnce;
  std::vector<Number3> partial(static_cast<std::size_t>(blocks) * 6 * count);

  tbb::parallel_for(0, blocks, [&](int block) {
    const int first = block * kRowsAtOnce;
    const int last = std::min(first + kRowsAtOnce, weights.half());
    const std::size_t row_weights = count * pairs * 2;
    std::vector<double> weight(row_weights * static_cast<std::size_t>(last - first));
    const auto weightsOf = [&](int row) {
      return std::span(weight).subspan(row_weights * static_cast<std::size_t>(row - first), row_weights);
    };
    for (int row = first; row < last; ++row) weights.rowWeights(row, pairs * 2, weightsOf(row));
    FoldedRow folded(pairs);
    for (std::size_t f = 0; f < 6; ++f) {  // one face at a time: memory is read in order
      Number3* const sum = partial.data() + (static_cast<std::size_t>(block) * 6 + f) * count;
      for (int row = first; row < last; ++row) {
        folded.fold(faces[f], size, row);
        for (int l = 0; l < bands; ++l)
          for (int m = -l; m <= l; ++m) {
            const Parity parity = parityOf(m);
            const double* const channel[3] = {folded.plane(parity, 0), folded.plane(parity, 1),
                                              folded.plane(parity, 2)};
            const auto k = static_cast<std::size_t>(indexOf(l, m));
            sum[k] += weightedSum(weightsOf(row).data() + k * pairs * 2, channel, pairs);
          }
      }
    }
  });

  std::vector<Number3> result(count);
  std::vector<double> in_face(count);
  std::vector<double> in_world(count);
  for (std::size_t f = 0; f < 6; ++f) {
    const Rotation to_world(bands, {faces[f].right, faces[f].down, faces[f].normal});
    for (int c = 0; c < 3; ++c) {
      std::fill(in_face.begin(), in_face.end(), 0.0);
      for (std::size_t block = 0; block < static_cast<std::size_t>(blocks); ++block)
        for (std::size_t k = 0; k < count; ++k) in_face[k] += partial[(block * 6 + f) * count + k][c];
      to_world.apply(in_face, in_world);
      for (std::size_t k = 0; k < count; ++k) result[k][c] += in_world[k];
    }
  }
  return result;
}

}  // namespace welkin::sh
