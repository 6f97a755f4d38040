// SPDX-License-Identifier: Apache-2.0
#include "measure.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <stdexcept>

#include "body.h"
#include "evaluate.h"
#include "render/vulkan_device.h"
#include "spirv/kUlpComp.h"
#include "tests/vulkan/compute.h"

namespace welkin::numerics {
namespace {

constexpr std::size_t kChunk = 65536;

/// Unit in the last place of a float of this magnitude.
double unitAt(double magnitude) {
  const double least = double{std::numeric_limits<float>::min()};
  return std::ldexp(1.0, std::ilogb(std::max(magnitude, least)) - 23);
}

double errorOf(const Slot& slot, double value, double expected, double unit) {
  double difference = std::abs(value - expected);
  if (slot.formula == "starCoordinates") difference = std::min(difference, std::abs(1.0 - difference));  // it wraps
  return difference >= 0.0 && difference < 1e30 ? difference / unit : 1e30;
}

void raise(Worst& worst, double ulp, const Slot& slot, std::span<const float> arguments) {
  if (ulp <= worst.ulp) return;
  worst.ulp = ulp;
  worst.where = describe(slot, arguments);
}

}  // namespace

std::vector<Measured> measure(std::size_t count, bool gpu, std::string& device_name) {
  const auto& all = slots();
  if (all.size() != WELKIN_NUMERICS_RESULTS)
    throw std::logic_error("WELKIN_NUMERICS_RESULTS must be " + std::to_string(all.size()));
  std::vector<Measured> formulas;
  std::vector<std::size_t> formula_of;
  for (const Slot& slot : all) {
    const auto known =
        std::find_if(formulas.begin(), formulas.end(), [&](const auto& m) { return m.formula == slot.formula; });
    formula_of.push_back(static_cast<std::size_t>(known - formulas.begin()));
    if (known == formulas.end()) formulas.push_back({slot.formula, {}, {}, 0.0});
  }
  std::optional<render::VulkanDevice> device;
  if (gpu) {
    device.emplace(true);
    device_name = device->properties().deviceName;
  }
  Values floats;
  Values doubles;
  for (std::size_t first = 0; first < count; first += kChunk) {
    const std::size_t n = std::min(kChunk, count - first);
    const std::vector<float> arguments = drawArguments(first, n);
    std::vector<float> results;
    if (device)
      results =
          tests::runCompute(*device, kUlpComp, arguments, n * all.size(), all.size(), VK_NULL_HANDLE, VK_NULL_HANDLE);
    for (std::size_t i = 0; i < n; ++i) {
      const std::span<const float> own(arguments.data() + i * WELKIN_NUMERICS_ARGUMENTS, WELKIN_NUMERICS_ARGUMENTS);
      evaluateAsFloats(own, floats);
      evaluateAsDoubles(own, doubles);
      for (std::size_t j = 0; j < all.size(); ++j) {
        Measured& m = formulas[formula_of[j]];
        const double unit = unitAt(std::max(std::abs(doubles.value[j]), doubles.size[j]));
        raise(m.floats, errorOf(all[j], floats.value[j], doubles.value[j], unit), all[j], own);
        if (!device) continue;
        const double shown = double{results[i * all.size() + j]};
        raise(m.gpu, errorOf(all[j], shown, doubles.value[j], unit), all[j], own);
        m.apart = std::max(m.apart, errorOf(all[j], shown, floats.value[j], unit));
      }
    }
  }
  return formulas;
}

}  // namespace welkin::numerics
