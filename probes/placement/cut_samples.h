// SPDX-License-Identifier: Apache-2.0
// Points of a cell that a tree of planes should part, and what each sees.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "probes/geometry/tracer.h"
#include "probes/placement/cell_faces.h"

namespace welkin::placement {

/// The distant light at a probe's place, in the transfer basis: sky visibility, and luminance from lamps.
struct ProbeLook {
  std::array<double, 4> sky{}, lamps{};
};

/// The probes of a sector: which of them see each other, and which may stand for each other.
class ProbeSight {
 public:
  /// `lamps_come`: the game hangs lamps here, so that places that do not see each other may have any light.
  ProbeSight(const geometry::Tracer& tracer, const std::vector<geometry::Probe>& probe,
             const std::vector<ProbeLook>& look, bool lamps_come);

  const Number3& position(std::size_t probe) const { return probe_[probe].position; }
  std::size_t size() const { return probe_.size(); }
  /// Whether two probes see each other and have nearly the same light; a probe is so to itself.
  bool akin(std::size_t a, std::size_t b) const { return akin_[a * probe_.size() + b] != 0; }
  /// Whether they are akin, or stand outdoors with no great difference of light, round a corner at most; in sight of
  /// each other where lamps come.
  bool alike(std::size_t a, std::size_t b) const { return alike_[a * probe_.size() + b] != 0; }
  /// Whether a chain of probes, each in sight of the next, joins the two.
  bool joined(std::size_t a, std::size_t b) const { return space_[a] == space_[b]; }

 private:
  const std::vector<geometry::Probe>& probe_;
  std::vector<std::uint8_t> akin_, alike_;
  std::vector<std::size_t> space_;
};

/// A point in the air.
struct CutSample {
  Number3 position;
  std::size_t nearest = 0;         ///< probe: the nearest that it sees
  double distance_m = 0.0;         ///< to it
  std::vector<std::uint8_t> sees;  ///< by probe of the sector: 0 not asked, 1 no, 2 yes
  std::uint32_t beside = 0;        ///< cells about it that the filter uses here, by format::openBit
  std::uint32_t shut = 0;          ///< those of them that it is parted from
};

/// The points of a cell: a jittered lattice, and points close to both sides of every face. Points in the dark, from
/// where no probe of the sector is in sight, are left out.
class CutSampler {
 public:
  CutSampler(const geometry::Tracer& tracer, const ProbeSight& sight, const geometry::SectorId& id)
      : tracer_(tracer), sight_(sight), id_(id) {}

  /// `faces` and the probes `near` the cell, whose box it is.
  std::vector<CutSample> samplesOf(std::size_t cell, const geometry::Box& box, const std::vector<CellFace>& faces,
                                   const std::vector<std::size_t>& near) const;

  /// Whether a sample sees a probe. Asks once.
  bool sees(CutSample& sample, std::size_t probe) const;
  /// Whether a probe may stand for a sample: it sees it, or its nearest probe is akin to it.
  bool serves(CutSample& sample, std::size_t probe) const {
    return sight_.akin(sample.nearest, probe) || sees(sample, probe);
  }
  /// Whether it does, or is at least no leak: the sample's nearest probe is alike, or so far that it says little, while
  /// this one is nearer and joined to it.
  bool fits(CutSample& sample, std::size_t probe) const;
  bool sees(const Number3& from, const Number3& to) const;
  /// The probes near a place, for nearestSeen of points about it.
  std::vector<std::size_t> probesNear(const Number3& place) const;
  /// The nearest of some probes that is in sight of a place; nothing if none is. `sees` gets the answers, where given.
  std::optional<std::size_t> nearestSeen(const Number3& from, const std::vector<std::size_t>& near,
                                         std::vector<std::uint8_t>* sees) const;

 private:
  const geometry::Tracer& tracer_;
  const ProbeSight& sight_;
  geometry::SectorId id_;
};

}  // namespace welkin::placement
