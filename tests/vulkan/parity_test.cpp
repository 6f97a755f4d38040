// SPDX-License-Identifier: Apache-2.0
// Every shared formula on the GPU against the same source in double.
#include "shaders/parity.h"

#include <catch2/catch.hpp>
#include <cstdint>
#include <random>

#include "compute.h"
#include "shared.h"
#include "spirv/kParityComp.h"
#include "worst.h"

namespace welkin::f64 {

/// The calls of parity.h, in double.
inline std::vector<Number> parityReference(const float* arguments) {
  const auto vector = [](const float* p) { return Number3(Number{p[0]}, Number{p[1]}, Number{p[2]}); };
  const Number3 a = vector(arguments);
  const Number time_h = Number{arguments[3]};
  const Number3 b = vector(arguments + 4);
  const Number angle_rad = Number{arguments[7]};
  const Number3 rgb = vector(arguments + 8);
  const Number x = Number{arguments[11]};
  std::vector<Number> results;
  const auto put = [&](Number value) { results.push_back(value); };
  const auto put3 = [&](Number3 value) { results.insert(results.end(), {value.x, value.y, value.z}); };
#define NUMBER(literal) Number(literal)
#define LuminanceModel(...) LuminanceModel{__VA_ARGS__}
  WELKIN_PARITY_BODY
#undef LuminanceModel
#undef NUMBER
  return results;
}

}  // namespace welkin::f64

namespace welkin::tests {
namespace {

/// Random arguments. The first ones are edge cases: zenith, nadir, horizon and either side of it, sun in the zenith,
/// black.
std::vector<float> parityArguments(std::size_t count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const f64::Number3 edges[] = {{0, 1, 0},  {0, -1, 0}, {1, 0, 0},      {0, 0, -1},       {0, 0, 1},
                                {-1, 0, 0}, {0, 1, 0},  {1, 1e-7, 0.0}, {1, -1e-7, 1e-9}, {1e-5, 1, 0}};
  const auto direction = [&](std::size_t i) {
    if (i < std::size(edges)) return edges[i];
    return f64::directionOf(f64::kTwoPi * unit(random), std::asin(2.0 * unit(random) - 1.0));
  };
  std::vector<float> arguments;
  for (std::size_t i = 0; i < count; ++i) {
    const f64::Number3 a = direction(i);
    const f64::Number3 b = direction(count - 1 - i);
    const double black = i % 16 == 0 ? 0.0 : 1.0;
    for (const double v : {a.x, a.y, a.z, 23.999 * unit(random), b.x, b.y, b.z, f64::kPi * (unit(random) - 0.5),
                           black * unit(random), black * unit(random), black * unit(random), 4.0 * unit(random) - 3.0})
      arguments.push_back(static_cast<float>(v));
  }
  return arguments;
}

/// Tolerance of a call, relative to the larger of 1 and the value. On the software rasteriser it is 16 units in the
/// last place, 2^-24 each. Where an angle comes from atan it is Mesa's 4e-6 rad, twice that for angleBetween, times |d|
/// = 3 for the indicatrix. On a GPU it is Vulkan's 4096 units of atan, through 30 theta exp(-3 theta): at most 3.7
/// times 4.9e-4.
double tolerance(const render::VulkanDevice& device, std::size_t call) {
  if (device.properties().deviceType != VK_PHYSICAL_DEVICE_TYPE_CPU) return 2e-3;
  const bool indicatrix_of_angle = call == 3 || call == 4 || call == 9 || call == 10;
  const bool angle = call == 5 || call == 6 || call == 7 || call == 22;
  return indicatrix_of_angle ? 2.4e-5 : angle ? 8e-6 : 16.0 / 16777216.0;
}

}  // namespace

TEST_CASE("SharedFormulas, GpuEqualsDouble", "[vulkan]") {
  constexpr std::size_t kInvocations = 2048;
  const std::vector<float> arguments = parityArguments(kInvocations);
  render::VulkanDevice device(true);
  const auto results = runCompute(device, kParityComp, arguments, kInvocations * WELKIN_PARITY_COUNT,
                                  WELKIN_PARITY_COUNT, VK_NULL_HANDLE, VK_NULL_HANDLE);
  std::vector<Worst> worst(WELKIN_PARITY_COUNT);
  for (std::size_t i = 0; i < kInvocations; ++i) {
    const std::vector<double> expected = f64::parityReference(arguments.data() + 12 * i);
    REQUIRE(expected.size() == WELKIN_PARITY_COUNT);
    for (std::size_t j = 0; j < WELKIN_PARITY_COUNT; ++j)
      worst[j].compare(double{results[i * WELKIN_PARITY_COUNT + j]}, expected[j], std::max(std::abs(expected[j]), 1.0),
                       [&] { return "call " + std::to_string(j) + " of arguments " + std::to_string(i); });
  }
  for (std::size_t j = 0; j < WELKIN_PARITY_COUNT; ++j) {
    INFO(worst[j].where);
    CHECK(worst[j].error < tolerance(device, j));
  }
  CHECK(device.messageCount() == 0);
}

}  // namespace welkin::tests
