// SPDX-License-Identifier: Apache-2.0
#include "study/quantity.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <span>

namespace welkin::study {
namespace {

struct Unit {
  double size;
  const char* name;
};

constexpr std::array<Unit, 4> kByteUnits = {{{1.0, "B"}, {1e3, "KB"}, {1e6, "MB"}, {1e9, "GB"}}};
constexpr std::array<Unit, 4> kTimeUnits = {{{1e-9, "ns"}, {1e-6, "us"}, {1e-3, "ms"}, {1.0, "s"}}};

// Writes no exponent where the number stays short: 0.001 and 120000, but 1e-05 and 1.2e+06.
std::string digitsOf(double value, int digits) {
  const double rounded = std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
  const double size = std::abs(rounded);
  if (size == 0.0) return "0";
  if (size < 1e-4 || size >= 1e6) return fmt::format("{:.{}g}", rounded, digits);
  return fmt::format("{}", rounded);
}

// Takes the largest unit that leaves at least 1 after rounding.
std::string withUnit(double value, std::span<const Unit> units, int digits) {
  const double rounded = std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
  const Unit* unit = &units.front();
  for (const Unit& candidate : units) {
    if (std::abs(rounded) >= candidate.size * (1.0 - 1e-12)) unit = &candidate;  // 1e-3 / 1e-6 is just below 1000
  }
  return digitsOf(value / unit->size, digits) + " " + unit->name;
}

}  // namespace

std::string inWords(double value, Quantity quantity, int digits) {
  switch (quantity) {
    case Quantity::number:
      return digitsOf(value, digits);
    case Quantity::share:
      return digitsOf(value * 100.0, digits) + " %";
    case Quantity::bytes:
      return value == 0.0 ? "0" : withUnit(value, kByteUnits, digits);
    case Quantity::seconds:
      return value == 0.0 ? "0" : withUnit(value, kTimeUnits, digits);
  }
  return {};
}

}  // namespace welkin::study
