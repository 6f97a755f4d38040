// SPDX-License-Identifier: Apache-2.0
#include "probes/build/shard.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "probes/geometry/sector_name.h"
#include "sky/base/error.h"

namespace welkin::build {
namespace {

constexpr int kMostShards = 1000000;

/// Reads a whole number that is all of the text.
bool readNumber(std::string_view text, int& value) {
  const char* end = text.data() + text.size();
  const auto [last, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && last == end;
}

}  // namespace

Shard parseShard(const std::string& text) {
  const std::size_t bar = text.find('/');
  Shard shard;
  if (bar == std::string::npos || !readNumber(std::string_view(text).substr(0, bar), shard.index) ||
      !readNumber(std::string_view(text).substr(bar + 1), shard.count) || shard.index < 0 ||
      shard.index >= shard.count || shard.count > kMostShards)
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("--shard {}: must be i/n with 0 <= i < n <= {}", text, kMostShards));
  return shard;
}

std::vector<geometry::SectorId> parseSectors(const std::string& text, const std::vector<geometry::SectorId>& level) {
  std::vector<geometry::SectorId> sectors;
  for (std::size_t first = 0; first <= text.size();) {
    const std::size_t end = std::min(text.find(',', first), text.size());
    const std::string name = text.substr(first, end - first);
    const auto sector = geometry::sectorOf(name);
    if (!sector)
      throw base::Error(base::ExitStatus::usage,
                        fmt::format("--sectors {}: \"{}\" is no sector, X_Z with X = floor(x / 64 m)", text, name));
    if (!std::binary_search(level.begin(), level.end(), *sector))
      throw base::Error(base::ExitStatus::usage, fmt::format("--sectors {}: the level has no sector {}", text, name));
    sectors.push_back(*sector);
    first = end + 1;
  }
  std::sort(sectors.begin(), sectors.end());
  sectors.erase(std::unique(sectors.begin(), sectors.end()), sectors.end());
  return sectors;
}

}  // namespace welkin::build
