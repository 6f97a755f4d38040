// SPDX-License-Identifier: Apache-2.0
#include "gloss/mips.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "sh/deterministic_materials.h"

namespace welkin::gloss {
namespace {

using det::Number3;

/// Sums over texels: what a mean over any of them needs.
struct Moments {
  Number3 normal;
  double length = 0.0;    ///< of the normals, each about 1: its rounding cancels in |mean| / mean length
  double variance = 0.0;  ///< 1/m

  void add(const Moments& other, double weight) {
    normal += other.normal * weight;
    length += other.length * weight;
    variance += other.variance * weight;
  }
};

/// A mip's means.
struct Means {
  int width = 0, height = 0;
  std::vector<Moments> texel;
};

/// The texels of `from` that one of `to` equal parts of an axis covers. A texel weighs as many of `from` parts as it
/// shares, so the weights are whole numbers and sum to `from`.
struct Cover {
  std::int64_t first, last, start, end, to;

  Cover(int part, int from, int parts)
      : start(std::int64_t{part} * from), end((std::int64_t{part} + 1) * from), to(parts) {
    first = start / to;
    last = (end - 1) / to;
  }
  double weight(std::int64_t i) const {
    return static_cast<double>(std::min(end, (i + 1) * to) - std::max(start, i * to));
  }
};

/// The mean of get(column, row) over a texel of a grid of other size.
template <typename Get>
Moments meanOver(const Cover& columns, const Cover& rows, Get&& get) {
  Moments sum;
  for (std::int64_t row = rows.first; row <= rows.last; ++row) {
    Moments line;
    for (std::int64_t column = columns.first; column <= columns.last; ++column)
      line.add(get(column, row), columns.weight(column));
    sum.add(line, rows.weight(row));
  }
  const double weight = static_cast<double>((columns.end - columns.start) * (rows.end - rows.start));
  return {sum.normal / weight, sum.length / weight, sum.variance / weight};
}

/// Mip 0, without a copy of it.
class Base {
 public:
  Base(const NormalMap& normals, const GlossMap& gloss)
      : normals_(normals),
        gloss_(gloss),
        variance_(gloss.number ? 1.0 / det::powerOfGloss(*gloss.number) : 0.0),
        same_size_(gloss.width == normals.width && gloss.height == normals.height) {}

  int width() const { return normals_.width; }
  int height() const { return normals_.height; }
  Moments at(std::int64_t column, std::int64_t row) const {
    const auto i = static_cast<std::size_t>(row * normals_.width + column);
    const float* n = normals_.xyz.data() + 3 * i;
    Moments moments{{double{n[0]}, double{n[1]}, double{n[2]}}, 0.0, variance_};
    moments.length = std::sqrt(dot(moments.normal, moments.normal));
    if (gloss_.number) return moments;
    moments.variance =
        same_size_ ? double{gloss_.variance[i]} : resized(static_cast<int>(column), static_cast<int>(row));
    return moments;
  }

 private:
  double resized(int column, int row) const {
    return meanOver(Cover(column, gloss_.width, width()), Cover(row, gloss_.height, height()),
                    [&](std::int64_t x, std::int64_t y) {
                      return Moments{{}, 0.0, double{gloss_.variance[static_cast<std::size_t>(y * gloss_.width + x)]}};
                    })
        .variance;
  }

  const NormalMap& normals_;
  const GlossMap& gloss_;
  double variance_;
  bool same_size_;
};

template <typename Get>
Means meansOf(int width, int height, int from_width, int from_height, const base::Progress& progress, Get&& get) {
  Means means{width, height, std::vector<Moments>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
  tbb::parallel_for(0, height, [&](int row) {
    const Cover rows(row, from_height, height);
    for (int column = 0; column < width; ++column)
      means.texel[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)] =
          meanOver(Cover(column, from_width, width), rows, get);
    progress.check();
  });
  return means;
}

/// The numbers that a mip keeps of each texel, and their sums over one row.
struct Row {
  double gloss = 0.0, factor = 0.0, least_length = 1.0;
};

template <typename Get>
Mip mipOf(int width, int height, Get&& get, const base::Progress& progress) {
  const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Mip mip{width, height, std::vector<float>(3 * texels), std::vector<float>(texels)};
  std::vector<Row> rows(static_cast<std::size_t>(height));
  tbb::parallel_for(0, height, [&](int row) {
    Row& sum = rows[static_cast<std::size_t>(row)];
    for (int column = 0; column < width; ++column) {
      const Moments mean = get(column, row);
      const double length = std::sqrt(dot(mean.normal, mean.normal));
      const double share = std::min(length / mean.length, 1.0);
      const double power = 1.0 / mean.variance;
      const double lowered = det::toksvigPower(power, share);
      const double gloss = det::glossOfPower(lowered);
      const Number3 n = length > 1e-9 ? mean.normal / length : Number3(0.0, 0.0, 1.0);
      const auto i = static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
      for (int c = 0; c < 3; ++c) mip.normal[3 * i + static_cast<std::size_t>(c)] = static_cast<float>(n[c]);
      mip.gloss[i] = static_cast<float>(gloss);
      sum.gloss += gloss;
      sum.factor += lowered / power;
      sum.least_length = std::min(sum.least_length, share);
    }
    progress.check();
  });
  double factor = 0.0;
  for (const Row& row : rows) {
    mip.mean_gloss += row.gloss;
    factor += row.factor;
    mip.least_length = std::min(mip.least_length, row.least_length);
  }
  mip.mean_gloss /= static_cast<double>(texels);
  mip.mean_factor = factor / static_cast<double>(texels);
  return mip;
}

}  // namespace

std::vector<Mip> mipsOf(const NormalMap& normals, const GlossMap& gloss, const base::Progress& progress) {
  const Base base(normals, gloss);
  const auto at_base = [&](std::int64_t column, std::int64_t row) { return base.at(column, row); };
  std::vector<Mip> mips{mipOf(base.width(), base.height(), at_base, progress)};
  // Means of earlier mips. A mip whose texels are whole ones of an earlier one has the same means from there.
  std::vector<Means> levels;
  for (int width = base.width(), height = base.height(); width > 1 || height > 1;) {
    width = std::max(width / 2, 1);
    height = std::max(height / 2, 1);
    const auto source = std::find_if(levels.rbegin(), levels.rend(), [&](const Means& level) {
      return level.width % width == 0 && level.height % height == 0;
    });
    Means means;
    if (source == levels.rend())
      means = meansOf(width, height, base.width(), base.height(), progress, at_base);
    else
      means = meansOf(width, height, source->width, source->height, progress, [&](std::int64_t x, std::int64_t y) {
        return source->texel[static_cast<std::size_t>(y * source->width + x)];
      });
    mips.push_back(mipOf(
        width, height,
        [&](int column, int row) {
          return means.texel[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                             static_cast<std::size_t>(column)];
        },
        progress));
    levels.push_back(std::move(means));
  }
  return mips;
}

AverageFactor averageFactorOf(const std::vector<Mip>& mips) {
  AverageFactor average;
  if (mips.size() == 1) return {mips[0].mean_gloss, 1.0};
  for (std::size_t k = 1; k < mips.size(); ++k) average.gloss += mips[k].mean_gloss;
  average.gloss /= static_cast<double>(mips.size() - 1);
  average.factor = det::powerOfGloss(average.gloss) / det::powerOfGloss(mips[0].mean_gloss);
  return average;
}

}  // namespace welkin::gloss
