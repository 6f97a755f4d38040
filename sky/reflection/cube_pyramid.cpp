// SPDX-License-Identifier: Apache-2.0
#include "sky/reflection/cube_pyramid.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <cstddef>

#include "sky/cubemap/cubemap.h"

namespace welkin::reflection {
namespace {

std::size_t texelOf(int size, int row, int column) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
}

/// An empty level: places and solid angles of its texels.
CubeLevel levelOf(int size) {
  CubeLevel level{size, {}, {}, {}, {}, {}};
  const std::size_t texels = texelOf(size, size, 0);
  level.rgb.resize(18 * texels);
  level.solid_angle.resize(texels);
  level.inverse_norm.resize(texels);
  const double step = 2.0 / size;
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const double s = column * step - 1.0, t = row * step - 1.0;
      const double middle_s = s + 0.5 * step, middle_t = t + 0.5 * step;
      level.solid_angle[texelOf(size, row, column)] =
          solidAngleTo(s + step, t + step) - solidAngleTo(s, t + step) - solidAngleTo(s + step, t) + solidAngleTo(s, t);
      level.inverse_norm[texelOf(size, row, column)] = 1.0 / std::sqrt(1.0 + middle_s * middle_s + middle_t * middle_t);
    }
  return level;
}

/// The level of half the size: means over solid angle.
CubeLevel halfOf(const CubeLevel& fine) {
  CubeLevel level = levelOf(fine.size / 2);
  level.along_s.resize(level.rgb.size());
  level.along_t.resize(level.rgb.size());
  tbb::parallel_for(0, 6 * level.size, [&](int stacked) {
    const int first_row = stacked / level.size * fine.size + 2 * (stacked % level.size);
    for (int column = 0; column < level.size; ++column) {
      const float* upper = fine.rgb.data() + 3 * texelOf(fine.size, first_row, 2 * column);
      const float* lower = fine.rgb.data() + 3 * texelOf(fine.size, first_row + 1, 2 * column);
      const double* above = fine.solid_angle.data() + texelOf(fine.size, first_row % fine.size, 2 * column);
      const double* below = above + fine.size;
      const double total = above[0] + above[1] + below[0] + below[1];
      const std::size_t at = 3 * texelOf(level.size, stacked, column);
      for (std::size_t c = 0; c < 3; ++c) {
        const double a = double{upper[c]}, b = double{upper[3 + c]}, d = double{lower[c]}, e = double{lower[3 + c]};
        level.rgb[at + c] = static_cast<float>((above[0] * a + above[1] * b + below[0] * d + below[1] * e) / total);
        level.along_s[at + c] = static_cast<float>(0.5 * (b + e - a - d));
        level.along_t[at + c] = static_cast<float>(0.5 * (d + e - a - b));
      }
    }
  });
  return level;
}

}  // namespace

double solidAngleTo(double s, double t) {
  return det::atan(s * t, std::sqrt(1.0 + s * s + t * t));
}

CubePyramid::CubePyramid(int size, const Radiance& radiance) {
  CubeLevel& first = levels_.emplace_back(levelOf(size));
  tbb::parallel_for(0, 6 * size, [&](int stacked) {
    const cubemap::FaceAxes axes = cubemap::faceAxes(cubemap::Layout::vulkan_cube, stacked / size);
    for (int column = 0; column < size; ++column) {
      const double s = (2 * column + 1.0) / size - 1.0, t = (2 * (stacked % size) + 1.0) / size - 1.0;
      const Number3 direction =
          (axes.normal + axes.right * s + axes.down * t) * first.inverse_norm[texelOf(size, stacked % size, column)];
      const Number3 colour = radiance(direction);
      for (int c = 0; c < 3; ++c)
        first.rgb[3 * texelOf(size, stacked, column) + static_cast<std::size_t>(c)] = static_cast<float>(colour[c]);
    }
  });
  while (levels_.back().size > 2) {
    CubeLevel next = halfOf(levels_.back());
    levels_.push_back(std::move(next));
  }
}

}  // namespace welkin::reflection
