// SPDX-License-Identifier: Apache-2.0
// What a person, or a script, has set in the viewer. It holds no results.
#pragma once

#include <cstddef>
#include <optional>

#include "baked/level_folder.h"
#include "probes/geometry/sector.h"
#include "render/level_frame.h"

namespace welkin::view {

/// What the spheres of probes show.
enum class ProbeShade { off, irradiance, visibility, sky, sun_bounce, local };
inline constexpr const char* kProbeShades[] = {"off", "irradiance", "visibility", "sky", "sun-bounce", "local"};

/// Where the light of surfaces in a picture comes from.
enum class Light {
  baked,      ///< sun and probes
  flat,       ///< sun and one ambient colour
  sky,        ///< sun and the open sky, as if nothing stood in its way
  reference,  ///< the path tracer
  other       ///< sun and probes of another bake of the level
};
inline constexpr const char* kLights[] = {"baked", "flat", "sky", "reference", "other"};

/// How two pictures are shown.
enum class Beside {
  wipe,       ///< the first left of a line, the second right of it
  side,       ///< the middles of both, side by side
  difference  ///< first minus second in false colours
};
inline constexpr const char* kBeside[] = {"wipe", "side", "difference"};

struct Comparison {
  Light first = Light::baked, second = Light::reference;
  Beside beside = Beside::wipe;
  double at = 0.5;  ///< the wipe's line, as a share of the width
  friend bool operator==(const Comparison&, const Comparison&) = default;
};

/// What is changed in the light without a bake.
struct Changes {
  double sky = 1.0, sun_bounce = 1.0, local = 1.0;  ///< factors on the probes' light, in [0, 16]
  double saturation = 1.0;                          ///< of ambient light, times the sky's own, in [0, 1]
  bool tint = true;                                 ///< the dome's polarising tint
  bool occlusion = false;                           ///< in screen space
  bool contact = true;                              ///< factors of the vertices, where the bake has them
  bool direct = true;                               ///< sun, moon and lamps themselves
  friend bool operator==(const Changes&, const Changes&) = default;
};

/// A probe by its sector and its number in the sector's file.
struct ProbeName {
  geometry::SectorId sector;
  std::size_t number = 0;
  friend bool operator==(const ProbeName&, const ProbeName&) = default;
};

struct Eye {
  f64::Number3 position{0.0};             ///< metres
  double yaw_deg = 0.0, pitch_deg = 0.0;  ///< clockwise from north, above the horizon
  double fov_deg = 60.0;                  ///< vertical
  friend bool operator==(const Eye&, const Eye&) = default;
};

struct State {
  double time_h = 12.0;  ///< in [0, 24)
  Eye eye;
  ProbeShade probes = ProbeShade::off;
  Light light = Light::baked;
  std::optional<Comparison> compare;
  std::optional<double> exposure_ev;  ///< none: automatic
  Changes changes;
  bool bounds = false;                       ///< draws the sectors' bounds
  std::size_t truth_paths = 4096;            ///< of the path tracer at the picked point
  std::size_t pixel_paths = 8;               ///< of the path tracer, a pixel
  std::optional<baked::SurfacePoint> point;  ///< picked on a surface
  std::optional<ProbeName> probe;            ///< picked
  bool edit = false;                         ///< shows what level.toml places by hand, and clicks select it
  std::optional<std::size_t> hand;           ///< the selected probe by hand
  std::optional<f64::Number3> corner;        ///< the first corner of a room that is drawn
};

}  // namespace welkin::view
