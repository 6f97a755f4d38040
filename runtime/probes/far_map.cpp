// SPDX-License-Identifier: Apache-2.0
#include "probes/far_map.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "format/domain_check.h"
#include "format/half.h"
#include "format/sector_check.h"
#include "probes/level.h"
#include "shared.h"

namespace welkin::probes {
namespace {

constexpr double kWidestBorder_m = 64.0;

std::size_t wrapped(std::int64_t index, std::uint32_t count) {
  const std::int64_t n = count;
  return static_cast<std::size_t>((index % n + n) % n);
}

/// A bit for each tile of a row.
using TileRows = std::array<std::uint64_t, FarMap::kMostTiles>;
static_assert(FarMap::kMostTiles == 64);

/// Takes a rectangle of set bits away: the first run of the first row, and the rows below that have all of it.
WelkinFarBox takeRectangle(TileRows& rows, std::uint32_t tiles) {
  std::uint32_t row = 0;
  while (rows[row] == 0) ++row;
  const auto from = static_cast<std::uint32_t>(std::countr_zero(rows[row]));
  const auto size = static_cast<std::uint32_t>(std::countr_one(rows[row] >> from));
  const std::uint64_t run = ~std::uint64_t{0} >> (64 - size) << from;
  std::uint32_t end = row;
  for (; end < tiles && (rows[end] & run) == run; ++end) rows[end] &= ~run;
  return {{kTileEdge * from, kTileEdge * row}, {kTileEdge * size, kTileEdge * (end - row)}};
}

/// The rectangles of all set bits, or the one about them all where they are too many.
void addRectangles(TileRows rows, std::uint32_t tiles, WelkinVolumeUpdate& out) {
  const auto isAny = [&] { return std::any_of(rows.begin(), rows.end(), [](std::uint64_t r) { return r != 0; }); };
  const TileRows all = rows;
  while (isAny() && out.far_box_count < WELKIN_VOLUME_MAX_FAR_BOXES)
    out.far_box[out.far_box_count++] = takeRectangle(rows, tiles);
  if (!isAny()) return;
  std::uint64_t any = 0;
  std::uint32_t first = tiles, last = 0;
  for (std::uint32_t j = 0; j < tiles; ++j) {
    any |= all[j];
    if (all[j] == 0) continue;
    first = std::min(first, j);
    last = j;
  }
  const auto from = static_cast<std::uint32_t>(std::countr_zero(any));
  const auto end = static_cast<std::uint32_t>(64 - std::countl_zero(any));
  out.far_box_count = 1;
  out.far_box[0] = {{kTileEdge * from, kTileEdge * first}, {kTileEdge * (end - from), kTileEdge * (last + 1 - first)}};
}

}  // namespace

LevelLight uniformSky() {
  LevelLight light;
  for (std::size_t c = 0; c < kChannels; ++c) {
    light.sky[0][c] = std::sqrt(f64::kPi);
    light.sky[1][c] = std::sqrt(3.0 * f64::kPi) / 2.0;
  }
  light.local = 0.0;
  light.common = commonOf(light, false);
  return light;
}

FarTile farTileOf(const format::Sector& sector, const float* light) {
  FarTile tile{};
  if (format::probesOf(sector) == 0) return tile;
  const format::Probes& probes = *sector.probes();
  const auto position = format::spanOf(probes.position());
  const auto top = format::spanOf(sector.top());
  const double low = double{probes.low_y()}, step = (double{probes.high_y()} - low) / 65535.0;
  const f64::TransferWeights up = f64::transferWeights({0.0, 1.0, 0.0});
  for (std::size_t i = 0; i < tile.size(); ++i) {
    f64::Number3 irradiance(0.0);
    for (std::size_t c = 0; c < kChannels; ++c)
      for (std::size_t b = 0; b < kDirections; ++b)
        irradiance[static_cast<int>(c)] += up.v[b] * double{light[kColours * top[i] + kDirections * c + b]};
    const double seen = std::clamp(f64::luminanceOf(irradiance) / f64::kPi, 0.0, 1.0);
    const std::uint16_t occlusion = format::halfFromFloat(static_cast<float>(1.0 - seen));
    const double height = low + step * position[std::size_t{3} * top[i] + 1];
    const auto occluded = static_cast<float>(double{format::floatFromHalf(occlusion)} * height);
    tile[i] = occlusion | std::uint32_t{format::halfFromFloat(occluded)} << 16;
  }
  return tile;
}

bool FarMap::allocate(const core::HostMemory& memory, std::uint32_t tiles, double fade_m) {
  tiles_ = tiles;
  fade_m_ = fade_m;
  const std::size_t texels = std::size_t{edge()} * edge();
  if (!texels_.allocate(memory, texels) || !held_.allocate(memory, std::size_t{tiles} * tiles)) return false;
  std::fill_n(texels_.get(), texels, 0U);
  std::fill_n(held_.get(), std::size_t{tiles} * tiles, std::uint64_t{0});
  return true;
}

double FarMap::low_m(std::size_t axis) const {
  return kSector_m * static_cast<double>(first_[axis]);
}

double FarMap::edge_m() const {
  return kSector_m * tiles_;
}

double FarMap::reach_m() const {
  // The camera is up to half a sector off the middle, and the outer half of a texel has no neighbour.
  return 0.5 * (edge_m() - kSector_m) - 0.5 * format::kCellWidth_m - kPush_m;
}

double FarMap::border_m() const {
  return std::min(kWidestBorder_m, 0.5 * reach_m());
}

bool FarMap::fill(const WelkinLevel& level, std::uint32_t i, std::uint32_t j) {
  const auto along = [&](std::uint32_t slot, std::size_t axis) {
    return static_cast<std::int32_t>(first_[axis] + static_cast<std::int64_t>(wrapped(slot - first_[axis], tiles_)));
  };
  const WelkinSector* sector = residentAt(level, along(i, 0), along(j, 1));
  const std::uint64_t arrival = sector == nullptr ? 0 : sector->arrival;
  std::uint64_t& held = held_.get()[i + std::size_t{tiles_} * j];
  if (held == arrival) return false;
  held = arrival;
  for (std::size_t z = 0; z < kTileEdge; ++z) {
    std::uint32_t* to = texels_.get() + kTileEdge * i + std::size_t{edge()} * (kTileEdge * j + z);
    if (sector == nullptr)
      std::fill_n(to, kTileEdge, 0U);
    else
      std::copy_n(sector->far_tile.data() + kTileEdge * z, kTileEdge, to);
  }
  return true;
}

void FarMap::update(const WelkinLevel& level, double x, double z, WelkinVolumeUpdate& out) {
  const double middle[2] = {x, z};
  std::array<std::int64_t, 2> first;
  for (std::size_t a = 0; a < 2; ++a)
    first[a] = static_cast<std::int64_t>(std::floor(middle[a] / kSector_m - 0.5 * tiles_ + 0.5));
  const bool is_new = residents_ == 0;
  if (!is_new && first == first_ && residents_ == level.residents + 1) return;
  first_ = first;
  residents_ = level.residents + 1;
  TileRows changed{};
  for (std::uint32_t j = 0; j < tiles_; ++j)
    for (std::uint32_t i = 0; i < tiles_; ++i)
      if (fill(level, i, j) || is_new) changed[j] |= std::uint64_t{1} << i;
  addRectangles(changed, tiles_, out);
}

std::array<double, 2> FarMap::at(double x, double z) const {
  const double place[2] = {x, z};
  std::size_t index[2][2];
  double share[2];
  for (std::size_t a = 0; a < 2; ++a) {
    const double half = 0.5 * format::kCellWidth_m;
    const double p = std::clamp(place[a], low_m(a) + half, low_m(a) + edge_m() - half) / format::kCellWidth_m - 0.5;
    share[a] = p - std::floor(p);
    for (std::int64_t i = 0; i < 2; ++i) index[a][i] = wrapped(static_cast<std::int64_t>(std::floor(p)) + i, edge());
  }
  std::array<double, 2> sum{};
  for (std::size_t i = 0; i < 4; ++i) {
    const double weight = (i % 2 == 0 ? 1.0 - share[0] : share[0]) * (i / 2 == 0 ? 1.0 - share[1] : share[1]);
    const std::uint32_t texel = texels_.get()[index[0][i % 2] + std::size_t{edge()} * index[1][i / 2]];
    sum[0] += weight * double{format::floatFromHalf(static_cast<std::uint16_t>(texel))};
    sum[1] += weight * double{format::floatFromHalf(static_cast<std::uint16_t>(texel >> 16))};
  }
  return sum;
}

}  // namespace welkin::probes
