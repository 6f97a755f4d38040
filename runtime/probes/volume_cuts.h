// SPDX-License-Identifier: Apache-2.0
// The cells along walls and faces of rooms inside a volume: their trees as words for shaders/shared/cuts.glsl, and for
// each side of these a brick of 3 x 3 x 3 texels.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "probes/cut_bricks.h"
#include "probes/cut_words.h"
#include "probes/rooms.h"

namespace welkin::probes {

/// Words of a sector's cells, and of them with the nodes of its trees.
inline constexpr std::uint32_t kCellWords = kNodeWords * format::kGridCells;
inline constexpr std::uint32_t kBlockWords = kCellWords + kNodeWords * kMostCutNodesPlaced;

/// Whether walls or rooms part cells of a sector, which may be null.
inline bool isParted(const WelkinSector* sector) {
  return sector != nullptr && (sector->cut.get() != nullptr || roomsOf(*sector) > 0);
}

/// Words and layers of bricks that an update changed.
struct CutChange {
  std::uint32_t first_word = 0, words = 0;
  std::uint32_t first_layer = 0, layers = 0;  ///< of which the texels are to be filled
};

/// A cell whose words are made.
struct BrickCell {
  const BrickSectors& sectors;
  format::CellPlace place;
  std::uint32_t slot;
  CutWords& tree;                         ///< to be made
  std::array<std::uint32_t, 64> brick{};  ///< some of its own
  std::size_t bricks = 0;
  bool has_brick = false;  ///< else the volume's own texels serve all of it
};

class VolumeCuts {
 public:
  /// For a volume of so many texels, with room for at least `bricks` bricks of such a volume, which lie in layers of
  /// the volume's width and height. False when memory runs out.
  bool allocate(const core::HostMemory& memory, const std::array<std::uint32_t, 3>& texels, double texel_height_m,
                std::uint32_t bricks);

  /// Follows the level's sectors about the volume's cells from (x, z) on. Sectors near the middle have the first
  /// choice. Makes the bricks of one sector, of more where `max_texels` allows. `version` is that of the light. Layers
  /// that show earlier light are chosen while they have at most `max_texels` texels, at least one.
  CutChange update(const WelkinLevel& level, std::int64_t x, std::int64_t z, std::uint64_t version,
                   std::uint32_t max_texels);

  std::span<const std::uint32_t> words() const { return {words_.get(), word_count_}; }
  const std::array<std::uint32_t, 2>& mask() const { return mask_; }
  const std::array<std::uint32_t, 2>& across() const { return across_; }
  std::uint32_t layers() const { return layers_; }
  std::uint32_t perLayer() const { return across_[0] * across_[1]; }
  /// Sectors with walls or rooms that found no place.
  std::uint32_t left() const;
  std::uint32_t bricks() const { return used_; }
  /// Texels of bricks that show earlier light, or none yet.
  std::uint32_t remaining() const;

  /// The probes of a brick, or null where there is none.
  const BrickProbes* probesOf(std::uint32_t brick) const {
    return brick < brick_count_ && owner_.get()[brick] != 0 ? brick_.get() + brick : nullptr;
  }
  /// The sector of one of them; null where it has gone or has no light.
  const WelkinSector* holderOf(BrickProbe probe) const {
    return probe == kDarkBrickProbe ? nullptr : slot_.get()[probe / 256].sector;
  }

 private:
  struct Slot {
    const WelkinSector* sector;  ///< null: free
    std::uint64_t arrival;
    std::int32_t x, z;
    bool stale, failed, wanted;
  };
  struct Wanted {
    const WelkinSector* sector;
    double away;
    std::uint32_t slot;
  };
  struct Window {
    std::int32_t low_x, low_z, high_x, high_z;
    bool operator==(const Window&) const = default;
  };

  std::uint32_t tableWords() const { return (mask_[0] + 1) * (mask_[1] + 1); }
  std::uint32_t& entryOf(std::int32_t x, std::int32_t z) const;
  std::uint32_t* blockOf(std::uint32_t slot) const { return words_.get() + tableWords() + slot * kBlockWords; }
  std::uint32_t brickWord(std::uint32_t brick) const;
  Slot* slotAt(std::int32_t x, std::int32_t z) const;
  void follow(const WelkinLevel& level);
  void touch(std::uint32_t first, std::uint32_t end);
  void markStale(std::int32_t x, std::int32_t z);
  void clear(std::uint32_t slot);
  void release(std::uint32_t slot);
  BrickSectors sectorsAbout(const WelkinSector& sector) const;
  bool build(std::uint32_t slot, bool& lacks_bricks);
  bool buildOrYield(std::uint32_t wanted);
  bool addDoors(const BrickCell& cell, std::uint32_t& nodes, std::uint32_t& root) const;
  std::uint32_t addParts(BrickCell& cell, std::uint32_t room);
  std::uint32_t addTree(BrickCell& cell, const RoomPart& part);
  std::uint32_t addLeaf(BrickCell& cell, const BrickPart& part);
  bool addBrick(std::uint32_t slot, const BrickProbes& probes, std::uint32_t& word);
  void chooseLayers(std::uint64_t version, std::uint32_t max_texels, CutChange& change);

  std::array<std::uint32_t, 3> texels_{};
  double texel_height_m_ = 4.0;
  std::array<std::uint32_t, 2> mask_{}, across_{};
  std::uint32_t layers_ = 0, brick_count_ = 0, slot_count_ = 0, word_count_ = 0;
  core::HostArray<std::uint32_t> words_;
  core::HostArray<Slot> slot_;
  core::HostArray<Wanted> wanted_;
  core::HostArray<BrickProbes> brick_;
  core::HostArray<std::uint32_t> owner_;  ///< of each brick: 1 + its slot; 0: free
  core::HostArray<std::uint64_t> lit_;    ///< version of the light of each layer; 0: to be filled at once
  std::uint32_t wanted_count_ = 0, used_ = 0, next_brick_ = 0, next_layer_ = 0, left_ = 0;
  std::uint32_t touched_first_ = 0, touched_end_ = 0;
  Window window_{};
  std::uint64_t residents_ = 0;  ///< WelkinLevel::residents + 1 of the last update; 0: none
  std::uint64_t version_ = 0;
};

}  // namespace welkin::probes
