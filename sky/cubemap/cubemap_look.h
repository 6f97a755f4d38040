// SPDX-License-Identifier: Apache-2.0
// Cubemaps as seen in the directions of a measurement. Most directions stay where they are while the sun moves: their
// texels are looked up once. Texels that no file holds are rendered as a bake would, where they are seen.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "sky/cubemap/cubemap_filter.h"
#include "sky/cubemap/dome_directions.h"

namespace welkin::cubemap {

using det::Number3;

/// Cubemaps as a file holds them: all of one size and format.
struct CubemapSet {
  int size = 0;  ///< >= 2
  format::CubemapFormat format = format::CubemapFormat::rgba16f;
  std::vector<double> time_h;                         ///< strictly ascending, in [0, 24), at least one
  std::vector<std::span<const std::uint8_t>> texels;  ///< one for every time, or none: those that a bake would make
};

/// Whether a direction above the horizon is at least a texel away from it, on its face: only those are compared.
bool isClearOfHorizon(int size, const Number3& direction);

/// The part that all looks at a set of cubemaps share.
class CubemapLooks {
 public:
  /// `sky` and `cubemaps` outlive it.
  CubemapLooks(const model::Sky& sky, const CubemapSet& cubemaps, const DirectionCounts& counts);

  /// Directions for a sun: first those that stay, as `staying` has them, then those about the sun.
  std::vector<WeightedDirection> directionsAround(const Number3& sun) const { return directions_.around(sun); }

  /// A direction that stays.
  struct Staying {
    model::DomeRay ray;
    bool compared;  ///< isClearOfHorizon; the rest is only there when it is
    Footprint footprint;
    std::array<model::DomeRay, 4> texel;  ///< the footprint's
  };
  const std::vector<Staying>& staying() const { return staying_; }

  const model::Sky& sky() const { return sky_; }
  const CubemapSet& cubemaps() const { return cubemaps_; }
  /// The table of the sky's luminance; null: exact.
  const model::IndicatrixTable* table() const { return table_ ? &*table_ : nullptr; }

 private:
  const model::Sky& sky_;
  const CubemapSet& cubemaps_;
  DomeDirections directions_;
  std::optional<model::IndicatrixTable> table_;
  std::vector<Staying> staying_;
};

/// A texel as a bake would make it.
struct RenderedTexel {
  std::size_t index = SIZE_MAX;
  Number3 exact, rounded;  ///< rounded to the format
};

/// Texels of one cubemap by the last bits of their index: directions about the sun share them.
using RecentTexels = std::array<RenderedTexel, 256>;

/// A look at one cubemap. Immutable.
class CubemapLook {
 public:
  /// `looks` outlives it.
  CubemapLook(const CubemapLooks& looks, std::size_t index);

  struct Shown {
    Number3 shown;  ///< by the cubemap
    Number3 exact;  ///< the same without rounding to the format
    Number3 model;  ///< the dome at the cubemap's own time
  };
  /// The views in the i-th direction that stays, which is compared.
  const Shown& staying(std::size_t i) const { return staying_[i]; }
  /// The views in another direction above the horizon, without `model` at the cubemap's own time, else without `exact`.
  Shown at(const model::DomeRay& ray, const Footprint& footprint, RecentTexels& recent, bool own_time) const;

 private:
  RenderedTexel render(std::size_t index, const model::DomeRay& ray) const;
  bool hasFile() const { return !looks_->cubemaps().texels.empty(); }
  Number3 fromFile(const Footprint& footprint) const;

  const CubemapLooks* looks_;
  std::size_t index_;
  model::SkyInstant instant_;
  std::vector<Shown> staying_;
};

}  // namespace welkin::cubemap
