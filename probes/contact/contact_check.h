// SPDX-License-Identifier: Apache-2.0
// The error that contact factors leave, measured beside the path tracer at points and hours that no fit has seen.
#pragma once

#include "probes/contact/contact_fit.h"

namespace welkin::contact {

/// Root mean squares of errors of the ambient light's luminance on static surfaces by area, relative to the open sky's
/// horizontal irradiance at the hour. The path tracer's own variance is taken off.
struct ContactError {
  double probes = 0.0;    ///< by the probes alone
  double contact = 0.0;   ///< with the factors, as bytes
  double interval = 0.0;  ///< half of the 95 % confidence interval of `contact`, from the spread over the points
};

struct ContactCheck {
  std::vector<std::pair<double, ContactError>> hour;  ///< by time of day, ascending
  ContactError all;                                   ///< over all hours
  std::size_t points = 0;                             ///< that count: a probe serves them, and a player can see them
};

struct CheckSettings {
  std::size_t points = 400;  ///< at most, on static triangles that a probe serves
  std::size_t paths = 256;   ///< of a point at an hour, at least 64
  int bounces = 2;           ///< as the probes'
};

/// Six hours of the day are measured. `bytes` are fitContact's. The rest is as fitContact has it.
ContactCheck checkContact(const geometry::Tracer& tracer, const model::Sky& sky,
                          const std::vector<sectors::SectorFile>& sectors, const PlacedVertices& vertices,
                          const std::vector<std::uint8_t>& bytes, const CheckSettings& settings,
                          const base::Progress& progress = {});

}  // namespace welkin::contact
