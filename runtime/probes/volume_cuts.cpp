// SPDX-License-Identifier: Apache-2.0
#include "probes/volume_cuts.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace welkin::probes {
namespace {

constexpr std::uint32_t kFour = 4;
constexpr std::uint32_t kMostSlots = 64;
constexpr std::uint32_t kBrickTexels = 27;
constexpr std::uint32_t kSectorTexels = 1U << 18;  ///< about as much work as the bricks of a sector

std::int32_t sectorOf(std::int64_t column) {
  return static_cast<std::int32_t>(column >> 4);  // rounds down
}

/// Whether bottom and height of the cells are such multiples of a cell as the table holds.
bool isPlaced(const format::GridView& grid) {
  const double low = grid.low_y / format::kCellWidth_m, height = grid.cell_height_m / format::kCellWidth_m;
  return low == std::floor(low) && std::abs(low) < 32768.0 && height == std::floor(height) && height >= 1.0 &&
         height < 256.0;
}

}  // namespace

bool VolumeCuts::allocate(const core::HostMemory& memory, const std::array<std::uint32_t, 3>& texels,
                          double texel_height_m, std::uint32_t bricks) {
  texels_ = texels;
  texel_height_m_ = texel_height_m;
  across_ = {texels[0] / 3, texels[1] / 3};
  layers_ = perLayer() == 0 ? 0 : (bricks + perLayer() - 1) / perLayer();
  brick_count_ = layers_ * perLayer();
  std::uint32_t table = 1, window = 1;
  for (std::size_t a = 0; a < 2; ++a) {
    const std::uint32_t sectors = (texels[2 * a] + 14) / format::kCellsAcross + 1;  // the cells lie in so many at most
    mask_[a] = std::bit_ceil(sectors) - 1;
    table *= mask_[a] + 1;
    window *= sectors;
  }
  slot_count_ = layers_ == 0 ? 0 : std::min(window, kMostSlots);
  word_count_ = table + slot_count_ * kBlockWords;
  if (!words_.allocate(memory, word_count_)) return false;
  std::fill_n(words_.get(), word_count_, 0U);
  if (slot_count_ == 0) return true;
  if (!slot_.allocate(memory, slot_count_) || !wanted_.allocate(memory, window) ||
      !brick_.allocate(memory, brick_count_) || !owner_.allocate(memory, brick_count_) ||
      !lit_.allocate(memory, layers_))
    return false;
  std::fill_n(slot_.get(), slot_count_, Slot{});
  std::fill_n(owner_.get(), brick_count_, 0U);
  std::fill_n(lit_.get(), layers_, std::uint64_t{0});
  return true;
}

std::uint32_t& VolumeCuts::entryOf(std::int32_t x, std::int32_t z) const {
  return words_
      .get()[(static_cast<std::uint32_t>(x) & mask_[0]) + (mask_[0] + 1) * (static_cast<std::uint32_t>(z) & mask_[1])];
}

VolumeCuts::Slot* VolumeCuts::slotAt(std::int32_t x, std::int32_t z) const {
  const std::uint32_t number = entryOf(x, z) & 0xffU;
  if (number == 0) return nullptr;
  Slot& slot = slot_.get()[number - 1];
  return slot.sector != nullptr && slot.x == x && slot.z == z ? &slot : nullptr;
}

void VolumeCuts::touch(std::uint32_t first, std::uint32_t end) {
  if (touched_first_ == touched_end_) {
    touched_first_ = first;
    touched_end_ = end;
  }
  touched_first_ = std::min(touched_first_, first);
  touched_end_ = std::max(touched_end_, end);
}

void VolumeCuts::markStale(std::int32_t x, std::int32_t z) {
  for (int i = 0; i < 9; ++i)
    if (Slot* slot = slotAt(x + i % 3 - 1, z + i / 3 - 1)) slot->stale = true;
}

/// Takes a slot's bricks and cells.
void VolumeCuts::clear(std::uint32_t slot) {
  const std::uint32_t first = tableWords() + slot * kBlockWords;
  for (std::uint32_t b = 0; b < brick_count_; ++b)
    if (owner_.get()[b] == slot + 1) {
      owner_.get()[b] = 0;
      --used_;
    }
  next_brick_ = 0;
  std::fill_n(words_.get() + first, kBlockWords, 0U);
  touch(first, first + kBlockWords);
}

void VolumeCuts::release(std::uint32_t slot) {
  Slot& s = slot_.get()[slot];
  clear(slot);
  // Bricks beside it that are not built again yet must not read what is gone: they have their own cell's light there.
  for (std::uint32_t b = 0; b < brick_count_; ++b) {
    if (owner_.get()[b] == 0) continue;
    for (BrickProbe& probe : brick_.get()[b]) {
      if (probe / 256 != slot) continue;
      probe = brick_.get()[b][13];
      lit_.get()[b / perLayer()] = 0;
    }
  }
  markStale(s.x, s.z);
  entryOf(s.x, s.z) = 0;
  touch(0, tableWords());
  s = {};
}

/// Gives slots to the sectors about the volume that have walls or rooms, or lie beside one that has.
void VolumeCuts::follow(const WelkinLevel& level) {
  wanted_count_ = 0;
  left_ = 0;
  for (std::int32_t z = window_.low_z; z <= window_.high_z; ++z)
    for (std::int32_t x = window_.low_x; x <= window_.high_x; ++x) {
      const WelkinSector* sector = residentAt(level, x, z);
      bool needed = false;
      for (int i = 0; i < 9 && sector != nullptr; ++i)
        needed = needed || isParted(residentAt(level, x + i % 3 - 1, z + i / 3 - 1));
      if (!needed) continue;
      if (!isPlaced(sector->grid)) {
        left_ += isParted(sector) ? 1U : 0U;
        continue;
      }
      const double dx = x - 0.5 * (window_.low_x + window_.high_x), dz = z - 0.5 * (window_.low_z + window_.high_z);
      wanted_.get()[wanted_count_++] = {sector, dx * dx + dz * dz, 0};
    }
  Wanted* wanted = wanted_.get();
  std::sort(wanted, wanted + wanted_count_, [](const Wanted& a, const Wanted& b) {
    if (a.away != b.away) return a.away < b.away;
    return a.sector->x != b.sector->x ? a.sector->x < b.sector->x : a.sector->z < b.sector->z;
  });
  for (; wanted_count_ > slot_count_; --wanted_count_) left_ += isParted(wanted[wanted_count_ - 1].sector) ? 1U : 0U;
  for (std::uint32_t s = 0; s < slot_count_; ++s) {
    slot_.get()[s].wanted = false;
    slot_.get()[s].stale = slot_.get()[s].stale || slot_.get()[s].failed;
  }
  for (std::uint32_t i = 0; i < wanted_count_; ++i)
    for (std::uint32_t s = 0; s < slot_count_; ++s) {
      Slot& slot = slot_.get()[s];
      if (slot.sector != wanted[i].sector || slot.arrival != wanted[i].sector->arrival) continue;
      slot.wanted = true;
      wanted[i].slot = s + 1;
    }
  for (std::uint32_t s = 0; s < slot_count_; ++s) {
    if (slot_.get()[s].sector == nullptr || slot_.get()[s].wanted) continue;
    release(s);
  }
  for (std::uint32_t i = 0; i < wanted_count_; ++i) {
    if (wanted[i].slot != 0) {
      --wanted[i].slot;
      continue;
    }
    std::uint32_t s = 0;
    while (slot_.get()[s].sector != nullptr) ++s;
    const WelkinSector& sector = *wanted[i].sector;
    slot_.get()[s] = {&sector, sector.arrival, sector.x, sector.z, true, false, true};
    wanted[i].slot = s;
    entryOf(sector.x, sector.z) = (s + 1) |
                                  static_cast<std::uint32_t>(sector.grid.cell_height_m / format::kCellWidth_m) << 8 |
                                  static_cast<std::uint32_t>(sector.grid.low_y / format::kCellWidth_m + 32768.0) << 16;
    touch(0, tableWords());
    markStale(sector.x, sector.z);
  }
}

BrickSectors VolumeCuts::sectorsAbout(const WelkinSector& sector) const {
  BrickSectors about{{}, sector.x, sector.z, texel_height_m_};
  for (int i = 0; i < 9; ++i) {
    const Slot* slot = slotAt(sector.x + i % 3 - 1, sector.z + i / 3 - 1);
    if (slot == nullptr) continue;
    about.sector[static_cast<std::size_t>(i)] = {&slot->sector->grid, slot->sector,
                                                 static_cast<std::uint32_t>(slot - slot_.get())};
  }
  return about;
}

/// A run of layers to fill: those with new bricks, or else some that show earlier light; all if there is no limit.
void VolumeCuts::chooseLayers(std::uint64_t version, std::uint32_t max_texels, CutChange& change) {
  std::uint64_t* lit = lit_.get();
  std::uint32_t used = 0;
  for (std::uint32_t b = 0; b < brick_count_; ++b)
    if (owner_.get()[b] != 0) used = b / perLayer() + 1;
  const auto isOld = [&](std::uint32_t layer) { return lit[layer] != version; };
  std::uint32_t first = used, end = 0, old = 0;
  for (std::uint32_t l = 0; l < used; ++l) {
    old += isOld(l) ? 1U : 0U;
    if (lit[l] != 0 && !(max_texels == UINT32_MAX && isOld(l))) continue;
    first = std::min(first, l);
    end = l + 1;
  }
  if (old == 0) return;
  if (first >= end) {
    first = next_layer_ % used;
    while (!isOld(first)) first = (first + 1) % used;
    const std::uint32_t most = std::max(1U, max_texels / (kBrickTexels * perLayer()));
    for (end = first; end < used && end - first < most && isOld(end);) ++end;
    next_layer_ = end;
  }
  std::fill(lit + first, lit + end, version);
  change.first_layer = first;
  change.layers = end - first;
}

std::uint32_t VolumeCuts::remaining() const {
  std::uint32_t count = 0;
  for (std::uint32_t b = 0; b < brick_count_; ++b)
    if (owner_.get()[b] != 0 && lit_.get()[b / perLayer()] != version_) count += kBrickTexels;
  for (std::uint32_t s = 0; s < slot_count_; ++s) count += slot_.get()[s].stale ? kBrickTexels : 0;
  return count;
}

std::uint32_t VolumeCuts::left() const {
  std::uint32_t count = left_;
  for (std::uint32_t s = 0; s < slot_count_; ++s)
    count += slot_.get()[s].failed && isParted(slot_.get()[s].sector) ? 1U : 0U;
  return count;
}

CutChange VolumeCuts::update(const WelkinLevel& level, std::int64_t x, std::int64_t z, std::uint64_t version,
                             std::uint32_t max_texels) {
  CutChange change;
  const Window window{sectorOf(x), sectorOf(z), sectorOf(x + texels_[0] - 1), sectorOf(z + texels_[2] - 1)};
  touched_first_ = touched_end_ = 0;
  if (residents_ == 0) touch(0, word_count_);  // the caller's copy of them holds anything
  if (residents_ != level.residents + 1 || !(window == window_)) {
    window_ = window;
    residents_ = level.residents + 1;
    if (slot_count_ > 0) follow(level);
  }
  version_ = version;
  std::uint32_t builds = std::max(1U, max_texels / kSectorTexels);
  for (std::uint32_t i = 0; i < wanted_count_ && builds > 0; ++i) {
    if (!slot_.get()[wanted_.get()[i].slot].stale) continue;
    buildOrYield(i);
    --builds;
  }
  if (slot_count_ > 0) chooseLayers(version, max_texels, change);
  change.first_word = touched_first_ / kFour * kFour;
  change.words = (touched_end_ + kFour - 1) / kFour * kFour - change.first_word;
  return change;
}

}  // namespace welkin::probes
