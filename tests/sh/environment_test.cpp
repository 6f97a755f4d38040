// SPDX-License-Identifier: Apache-2.0
// Projection of cubemaps and latlongs: against slow sums of the same texels, against functions with known coefficients.
#include "sh/environment.h"

#include <tbb/global_control.h>

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <random>

#include "sh/basis.h"

namespace welkin::sh {
namespace {

using det::Number3;
using Radiance = std::function<double(const Number3&)>;

Number3 normalised(const Number3& v) {
  return v / std::sqrt(dot(v, v));
}

/// Vulkan's faces: right, down, normal.
const std::array<std::array<Number3, 3>, 6> kAxes = {{{Number3(0, 0, -1), Number3(0, -1, 0), Number3(1, 0, 0)},
                                                      {Number3(0, 0, 1), Number3(0, -1, 0), Number3(-1, 0, 0)},
                                                      {Number3(1, 0, 0), Number3(0, 0, 1), Number3(0, 1, 0)},
                                                      {Number3(1, 0, 0), Number3(0, 0, -1), Number3(0, -1, 0)},
                                                      {Number3(1, 0, 0), Number3(0, -1, 0), Number3(0, 0, 1)},
                                                      {Number3(-1, 0, 0), Number3(0, -1, 0), Number3(0, 0, -1)}}};

/// Six faces below each other.
struct Cube {
  int size;
  std::vector<float> rgb;

  std::array<CubeFace, 6> faces() const {
    std::array<CubeFace, 6> result;
    for (std::size_t f = 0; f < 6; ++f)
      result[f] = {rgb.data() + f * 3 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size),
                   std::ptrdiff_t{3} * size, kAxes[f][0], kAxes[f][1], kAxes[f][2]};
    return result;
  }
};

std::vector<float> noise(std::size_t texels, unsigned seed) {
  std::mt19937 random(seed);
  std::exponential_distribution<float> value(1.0F);
  std::vector<float> rgb(texels * 3);
  for (float& v : rgb) v = value(random);
  rgb[rgb.size() / 5] = 1000.0F;  // and a lamp
  return rgb;
}

double centre(TexelRule rule, int size, int i) {
  return rule == TexelRule::half_texel ? (i + 0.5) / size : double(i) / (size - 1);
}

/// What texel i stands for, at u in [0, 1]: 1 over it, or a hat over its two cells.
double kernel(TexelRule rule, int size, int i, double u) {
  if (rule == TexelRule::half_texel) return u * size >= i && u * size < i + 1 ? 1.0 : 0.0;
  return std::max(0.0, 1.0 - std::abs(u * (size - 1) - i));
}

/// Calls visit(u, weight) with a rule that integrates the basis to rounding on every cell of an axis.
template <typename Visit>
void overAxis(TexelRule rule, int size, Visit&& visit) {
  static const GaussRule kMany = gaussLegendre(48);
  static const GaussRule kFew = gaussLegendre(16);
  const int cells = rule == TexelRule::half_texel ? size : size - 1;
  for (int c = 0; c < cells; ++c) forEachNode(size < 6 ? kMany : kFew, double(c) / cells, double(c + 1) / cells, visit);
}

/// The picture's value at (u, v), by its rule and nothing else.
double interpolated(const float* rgb, TexelRule rule, int width, int height, double u, double v, int channel) {
  double sum = 0.0;
  for (int y = 0; y < height; ++y) {
    const double ky = kernel(rule, height, y, v);
    if (ky == 0.0) continue;
    for (int x = 0; x < width; ++x) sum += ky * kernel(rule, width, x, u) * double{rgb[3 * (y * width + x) + channel]};
  }
  return sum;
}

std::vector<Number3> slowCube(const Cube& cube, TexelRule rule, int bands) {
  const LatitudeRecurrence recurrence(bands);
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(bands)));
  std::vector<Number3> sum(basis.size());
  const auto faces = cube.faces();
  for (const CubeFace& face : faces)
    overAxis(rule, cube.size, [&](double v, double wv) {
      overAxis(rule, cube.size, [&](double u, double wu) {
        const Number3 d = face.normal + face.right * (2.0 * u - 1.0) + face.down * (2.0 * v - 1.0);
        const double solid_angle = 4.0 * wu * wv / std::pow(dot(d, d), 1.5);
        evaluateBasis(recurrence, normalised(d), basis);
        for (int c = 0; c < 3; ++c) {
          const double value = interpolated(face.rgb, rule, cube.size, cube.size, u, v, c) * solid_angle;
          for (std::size_t k = 0; k < basis.size(); ++k) sum[k][c] += value * basis[k];
        }
      });
    });
  return sum;
}

std::vector<Number3> slowLatlong(const std::vector<float>& rgb, int width, int height, TexelRule rule, int bands) {
  const LatitudeRecurrence recurrence(bands);
  std::vector<double> basis(static_cast<std::size_t>(coefficientCount(bands)));
  std::vector<Number3> sum(basis.size());
  overAxis(rule, height, [&](double v, double wv) {
    overAxis(rule, width, [&](double u, double wu) {
      const double longitude = M_PI - 2.0 * M_PI * u;
      const double c = std::sin(M_PI * v);
      evaluateBasis(recurrence, {c * std::sin(longitude), std::cos(M_PI * v), c * std::cos(longitude)}, basis);
      for (int channel = 0; channel < 3; ++channel) {
        const double value =
            interpolated(rgb.data(), rule, width, height, u, v, channel) * 2.0 * M_PI * M_PI * c * wu * wv;
        for (std::size_t k = 0; k < basis.size(); ++k) sum[k][channel] += value * basis[k];
      }
    });
  });
  return sum;
}

/// Largest difference of any coefficient, in units of the largest c0.
double difference(const std::vector<Number3>& a, const std::vector<Number3>& b) {
  double worst = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k)
    for (int c = 0; c < 3; ++c) worst = std::max(worst, std::abs(a[k][c] - b[k][c]));
  return worst / std::max({b[0].x, b[0].y, b[0].z});
}

/// A picture sampled at its texels' centres, the same in every channel.
Cube sampledCube(int size, TexelRule rule, const Radiance& radiance) {
  Cube cube{size, {}};
  cube.rgb.reserve(18 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  for (const auto& axes : kAxes)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x) {
        const double value = radiance(normalised(axes[2] + axes[0] * (2.0 * centre(rule, size, x) - 1.0) +
                                                 axes[1] * (2.0 * centre(rule, size, y) - 1.0)));
        cube.rgb.insert(cube.rgb.end(), 3, static_cast<float>(value));
      }
  return cube;
}

std::vector<float> sampledLatlong(int width, int height, TexelRule rule, const Radiance& radiance) {
  std::vector<float> rgb;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const double longitude = M_PI - 2.0 * M_PI * centre(rule, width, x);
      const double polar = M_PI * centre(rule, height, y);
      const Number3 d(std::sin(polar) * std::sin(longitude), std::cos(polar), std::sin(polar) * std::cos(longitude));
      rgb.insert(rgb.end(), 3, static_cast<float>(radiance(d)));
    }
  return rgb;
}

/// exp(4 (d . axis - 1)) and its coefficients: 2 pi times the Legendre moments of exp(4 (t - 1)) on the axis.
const Number3 kAxis = normalised({1.0, 2.0, 3.0});
double lobe(const Number3& d) {
  return std::exp(4.0 * (dot(d, kAxis) - 1.0));
}
std::vector<Number3> lobeCoefficients() {
  const double e = std::exp(-8.0);
  const double m0 = (1.0 - e) / 4.0;
  const double m1 = (1.0 + e) / 4.0 - m0 / 4.0;
  const double m2 = (1.0 - e) / 4.0 - m1 / 2.0;
  const double zonal[3] = {2.0 * M_PI * m0, 2.0 * M_PI * m1, 2.0 * M_PI * 0.5 * (3.0 * m2 - m0)};
  std::vector<double> basis(9);
  evaluateBasis(LatitudeRecurrence(3), kAxis, basis);
  std::vector<Number3> result;
  for (int l = 0; l < 3; ++l)
    for (int m = -l; m <= l; ++m) result.push_back(Number3(zonal[l] * basis[static_cast<std::size_t>(indexOf(l, m))]));
  return result;
}

constexpr double kNodes = 1e-10;  // what the nodes a cell leave, of c0
constexpr TexelRule kRules[] = {TexelRule::half_texel, TexelRule::edge_centres};

}  // namespace

TEST_CASE("ProjectCube, IsTheSlowSumOfTheSameTexels") {
  for (const TexelRule rule : kRules)
    for (const int size : {1, 2, 3, 4, 5, 8, 16}) {
      if (rule == TexelRule::edge_centres && size == 1) continue;
      const Cube cube{size, noise(6 * static_cast<std::size_t>(size * size), 3)};
      for (const int bands : {1, 3, kMostBands}) {
        if (bands == kMostBands && size > 8) continue;
        CAPTURE(static_cast<int>(rule), size, bands);
        const double error = difference(projectCube(cube.faces(), size, rule, bands), slowCube(cube, rule, bands));
        CAPTURE(error * 1e12);
        CHECK(error < kNodes);
      }
    }
}

TEST_CASE("ProjectLatlong, IsTheSlowSumOfTheSameTexels") {
  for (const TexelRule rule : kRules)
    for (const auto& [width, height] : {std::pair(1, 1), {2, 2}, {3, 2}, {8, 4}, {7, 5}, {40, 18}}) {
      if (rule == TexelRule::edge_centres && width == 1) continue;
      const auto rgb = noise(static_cast<std::size_t>(width * height), 5);
      for (const int bands : {1, 3, kMostBands}) {
        CAPTURE(static_cast<int>(rule), width, height, bands);
        REQUIRE(difference(projectLatlong(rgb.data(), width, height, rule, bands),
                           slowLatlong(rgb, width, height, rule, bands)) < kNodes);
      }
    }
}

TEST_CASE("ProjectCube, WeightsOfLargeFacesAreIntegralsToo") {
  // Fewer nodes a cell there: the same weights as on faces four times finer, whose texels are four by four copies.
  for (const int size : {64, 128, 256}) {
    const Cube coarse{size, noise(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 11)};
    Cube fine{2 * size, std::vector<float>(coarse.rgb.size() * 4)};
    const auto n = static_cast<std::size_t>(size);
    for (std::size_t row = 0; row < 12 * n; ++row)
      for (std::size_t column = 0; column < 2 * n; ++column)
        for (std::size_t c = 0; c < 3; ++c)
          fine.rgb[3 * (row * 2 * n + column) + c] = coarse.rgb[3 * (row / 2 * n + column / 2) + c];
    CAPTURE(size);
    const double error = difference(projectCube(coarse.faces(), size, TexelRule::half_texel, 5),
                                    projectCube(fine.faces(), 2 * size, TexelRule::half_texel, 5));
    CAPTURE(error * 1e12);
    CHECK(error < kNodes);
  }
}

TEST_CASE("ProjectCube, AConstantHasOneCoefficient") {
  for (const TexelRule rule : kRules)
    for (const int size : {2, 7, 256}) {
      const Cube cube = sampledCube(size, rule, [](const Number3&) { return 1.0; });
      const auto sh = projectCube(cube.faces(), size, rule, 5);
      REQUIRE(std::abs(sh[0].x - 2.0 * std::sqrt(M_PI)) < kNodes);
      for (std::size_t k = 1; k < sh.size(); ++k) CHECK(std::abs(sh[k].y) < kNodes);
    }
}

TEST_CASE("ProjectCube, ErrorFallsWithTheSquareOfTheSize") {
  // A smooth lobe, sampled at the centres: constant texels differ from it by h^2 / 24 of its second derivative, hats by
  // twice as much. Measured: 0.42 and 0.86 to 0.97 times 1 / N^2; 4e-7 and 8e-7 at N = 1024.
  const auto truth = lobeCoefficients();
  for (const TexelRule rule : kRules) {
    double before = 1.0;
    for (const int size : {16, 64, 256, 1024}) {
      const Cube cube = sampledCube(size, rule, lobe);
      const double error = difference(projectCube(cube.faces(), size, rule, 3), truth);
      CAPTURE(static_cast<int>(rule), size, error);
      REQUIRE(error < before / 12.0);  // 16 but for the first term's company
      REQUIRE(error * size * size < 1.0);
      before = error;
    }
  }
}

TEST_CASE("ProjectLatlong, ErrorFallsWithTheSquareOfTheSize") {
  const auto truth = lobeCoefficients();
  for (const TexelRule rule : kRules) {
    double before = 1.0;
    for (const int height : {32, 128, 512}) {
      const auto rgb = sampledLatlong(2 * height, height, rule, lobe);
      const double error = difference(projectLatlong(rgb.data(), 2 * height, height, rule, 3), truth);
      CAPTURE(static_cast<int>(rule), height, error);
      REQUIRE(error < before / 12.0);
      before = error;
    }
  }
}

TEST_CASE("ProjectCube, TexelsMayLieAnywhere") {
  constexpr int kSize = 6;
  const Cube cube{kSize, noise(6 * kSize * kSize, 9)};
  // The same faces upside down in memory, within wider rows.
  constexpr std::ptrdiff_t kRow = 3 * (kSize + 5);
  auto faces = cube.faces();
  std::vector<float> wide(6 * kSize * kRow, -1.0F);
  for (std::size_t f = 0; f < 6; ++f) {
    float* const bottom = wide.data() + static_cast<std::ptrdiff_t>(f) * kSize * kRow + (kSize - 1) * kRow + 6;
    for (int row = 0; row < kSize; ++row) std::copy_n(faces[f].rgb + row * 3 * kSize, 3 * kSize, bottom - row * kRow);
    faces[f].rgb = bottom;
    faces[f].row = -kRow;
  }
  REQUIRE(difference(projectCube(faces, kSize, TexelRule::half_texel, 4),
                     projectCube(cube.faces(), kSize, TexelRule::half_texel, 4)) < 1e-14);
}

TEST_CASE("ProjectCube, SameBitsForAnyNumberOfThreads") {
  const Cube cube{97, noise(6 * 97 * 97, 21)};
  const auto rgb = noise(200 * 101, 22);
  std::vector<std::vector<Number3>> cubes, latlongs;
  for (const std::size_t threads : {1U, 2U, 8U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    cubes.push_back(projectCube(cube.faces(), 97, TexelRule::half_texel, 3));
    latlongs.push_back(projectLatlong(rgb.data(), 200, 101, TexelRule::half_texel, 3));
  }
  for (std::size_t i = 1; i < 3; ++i)
    for (std::size_t k = 0; k < 9; ++k)
      for (int c = 0; c < 3; ++c) {
        REQUIRE(cubes[i][k][c] == cubes[0][k][c]);
        REQUIRE(latlongs[i][k][c] == latlongs[0][k][c]);
      }
}

}  // namespace welkin::sh
