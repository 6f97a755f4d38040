// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/path_points.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "probes/geometry/directions.h"

namespace welkin::tests {

using f64::Number3;
namespace {

/// Mean over many replicates, with a limit for three standard errors. Values are within [-1, 1], and the points of each
/// replicate are better than independent.
constexpr std::uint32_t kPoints = 256;
constexpr std::uint64_t kReplicateKeys = 200;
const double kNoise = 3.0 / std::sqrt(double{kPoints} * kReplicateKeys);

template <typename Value>
double meanOf(const Value& value) {
  const transfer::CircleTable circle;
  double sum = 0.0;
  for (std::uint64_t key = 0; key < kReplicateKeys; ++key) {
    const transfer::PathPoints points(circle, geometry::mixed(key), 3);
    for (std::uint32_t i = 0; i < kPoints; ++i) sum += value(points, i);
  }
  return sum / (double{kPoints} * kReplicateKeys);
}

}  // namespace

TEST_CASE("PathPoints, SequenceIsANet") {
  // Each elementary interval of area 2^-18 has one of the first 2^18 points, whatever the key. The same holds for
  // blocks.
  constexpr int kBits = 18;
  const transfer::Sequence sequence(0x1234);
  for (const std::uint32_t block : {0U, 5U})
    for (const int columns : {0, 5, 9, 18}) {
      std::vector<char> taken(1U << kBits);
      std::size_t twice = 0;
      for (std::uint32_t i = 0; i < 1U << kBits; ++i) {
        const auto point = sequence.point((block << kBits) + i);
        const std::uint64_t cell = (((std::uint64_t{point.s} << columns) >> 32) << (kBits - columns)) +
                                   ((std::uint64_t{point.t} << (kBits - columns)) >> 32);
        twice += static_cast<std::size_t>(taken[cell]);
        taken[cell] = 1;
      }
      CHECK(twice == 0);
    }
  CHECK(sequence.value(77) == sequence.point(77).s);
}

TEST_CASE("PathPoints, SphereIsUniform") {
  CHECK(std::abs(meanOf([](const transfer::PathPoints& p, std::uint32_t i) {
          const Number3 w = p.onSphere(i);
          return std::abs(dot(w, w) - 1.0);
        })) < 1e-12);
  // Moments along every axis and mixed ones.
  for (const Number3& axis :
       {Number3(1, 0, 0), Number3(0, 1, 0), Number3(0, 0, 1), geometry::unit(Number3(1, -2, 3))}) {
    const auto moment = [&](int power) {
      return meanOf(
          [&](const transfer::PathPoints& p, std::uint32_t i) { return std::pow(dot(p.onSphere(i), axis), power); });
    };
    CHECK(std::abs(moment(1)) < kNoise);
    CHECK(moment(2) == Approx(1.0 / 3).margin(kNoise));
    CHECK(std::abs(moment(3)) < kNoise);
    CHECK(moment(4) == Approx(1.0 / 5).margin(kNoise));
  }
}

TEST_CASE("PathPoints, BouncesFollowTheCosine") {
  const Number3 normal = geometry::unit(Number3(0.4, -0.7, -0.5));
  const Number3 across = geometry::unit(cross(normal, Number3(0, 1, 0)));
  for (const int bounce : {0, 2}) {
    const auto mean = [&](auto&& value) {
      return meanOf(
          [&](const transfer::PathPoints& p, std::uint32_t i) { return value(p.aboutNormal(bounce, i, normal)); });
    };
    CHECK(mean([](const Number3& w) { return std::abs(dot(w, w) - 1.0); }) < 1e-12);
    CHECK(mean([&](const Number3& w) { return dot(w, normal); }) == Approx(2.0 / 3).margin(kNoise));
    CHECK(mean([&](const Number3& w) { return dot(w, normal) * dot(w, normal); }) == Approx(0.5).margin(kNoise));
    CHECK(std::abs(mean([&](const Number3& w) { return dot(w, across); })) < kNoise);
    CHECK(mean([&](const Number3& w) { return dot(w, across) * dot(w, across); }) == Approx(0.25).margin(kNoise));
    // Bounces are independent of the first direction and of each other.
    CHECK(std::abs(meanOf([&](const transfer::PathPoints& p, std::uint32_t i) {
            return dot(p.aboutNormal(bounce, i, normal), across) * p.onSphere(i).y;
          })) < kNoise);
    CHECK(std::abs(meanOf([&](const transfer::PathPoints& p, std::uint32_t i) {
            return (p.lightOffset(bounce, i) - 0.5) * p.onSphere(i).y;
          })) < kNoise);
    CHECK(std::abs(meanOf([&](const transfer::PathPoints& p, std::uint32_t i) {
            return dot(p.aboutNormal(bounce, i, normal), across) * dot(p.aboutNormal(1, i, normal), across);
          })) < kNoise);
  }
}

}  // namespace welkin::tests
