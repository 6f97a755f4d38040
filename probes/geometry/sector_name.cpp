// SPDX-License-Identifier: Apache-2.0
#include "probes/geometry/sector_name.h"

#include <fmt/format.h>

#include <charconv>

namespace welkin::geometry {
namespace {

std::optional<int> numberOf(std::string_view text) {
  int value = 0;
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || last != end || value < -kFarthestSector || value > kFarthestSector) return std::nullopt;
  return value;
}

}  // namespace

std::string nameOf(SectorId sector) {
  return fmt::format("{}_{}", sector.x, sector.z);
}

std::optional<SectorId> sectorOf(std::string_view name) {
  const std::size_t bar = name.find('_');
  if (bar == std::string_view::npos) return std::nullopt;
  const auto x = numberOf(name.substr(0, bar));
  const auto z = numberOf(name.substr(bar + 1));
  if (!x || !z || nameOf({*x, *z}) != name) return std::nullopt;  // no "-0", no "01"
  return SectorId{*x, *z};
}

std::string fileNameOf(SectorId sector) {
  return "sector_" + nameOf(sector) + ".welkin";
}

}  // namespace welkin::geometry
