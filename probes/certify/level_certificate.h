// SPDX-License-Identifier: Apache-2.0
// The error that a baked level really has, where players see it: on static surfaces by area, and in the air above
// walkable ground. Beside the path tracer, at random points that no fit has seen, through the runtime's look-up.
#pragma once

#include <cstdint>
#include <vector>

#include "probes/geometry/tracer.h"
#include "probes/sectors/level_light.h"
#include "sky/base/progress.h"

namespace welkin::certify {

using f64::Number3;

struct CertifySettings {
  std::size_t surface_points = 256;  ///< of the whole level, spread evenly over its sectors and weighted by area
  std::size_t air_points = 128;
  std::size_t paths = 256;  ///< of a point at an hour, at least 64
  int bounces = 2;
  bool all_hours = false;  ///< the 24 full hours; else the middle of each third of the day, and the worst of the 24
  std::uint64_t seed = 0xce47;  ///< of points and paths; not the fit's
};

/// Root mean square of an error of luminance, relative to the open sky's horizontal irradiance at the hour. The path
/// tracer's own variance is taken off.
struct RmsError {
  double rms = 0.0;
  double interval = 0.0;  ///< half of the 95 % confidence interval, from the spread over the points
};

/// The error of a part of the light.
struct PartError : RmsError {
  double nothing = 0.0;  ///< rms of the part itself, which is the error where it is left out
  bool worse = false;    ///< whether leaving it out has the smaller mean square, beyond the 95 % confidence interval
};

struct ErrorsOf {
  PartError sky, sun_bounce, local;
  RmsError total;
  RmsError nothing;      ///< of no light at all, for comparison
  double without = 0.0;  ///< share of the area that no probe serves; its error is that of no light
};

struct HourErrors {
  double time_h = 0.0;
  ErrorsOf surface, air;
};

struct WorstPoint {
  Number3 position, normal;
  double time_h = 0.0;
  double error = 0.0;  ///< of the total, signed: above 0 where the probes are too bright
};

struct LevelCertificate {
  std::vector<HourErrors> hour;  ///< ascending
  ErrorsOf surface, air;         ///< root mean square over the hours
  std::vector<WorstPoint>
      worst;  ///< the worst per cent of the surface's points, at most kMostWorst, each at its worst hour
  std::size_t surface_points = 0, air_points = 0;
  double surface_m2 = 0.0, air_m2 = 0.0;  ///< areas that the points stand for
};

inline constexpr std::size_t kMostWorst = 16;

/// Measures a level. `tracer` is that of the whole level, without reach; the sectors are all of it. Factors of [scale]
/// do not count. Runs on all threads of the caller's arena; the result is the same for any number of them.
LevelCertificate certifyLevel(const geometry::Tracer& tracer, const model::Sky& sky,
                              const std::vector<sectors::SectorFile>& sectors, const CertifySettings& settings,
                              const base::Progress& progress = {});

}  // namespace welkin::certify
