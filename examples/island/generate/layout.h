// SPDX-License-Identifier: Apache-2.0
// Places of the huts, the paths between them, the jetty, the boats and the wreck.
#pragma once

#include <array>

#include "generate/geometry.h"

namespace welkin::island {

/// A place on the map. The front looks along the azimuth, clockwise from north.
struct Place {
  double x = 0.0;
  double z = 0.0;
  double azimuth_deg = 0.0;
};

struct HutPlace {
  Place place;
  bool onStilts = true;
  const char* wall = "";  ///< material
};

inline constexpr std::array<HutPlace, 8> kHuts = {{{{7.0, 45.0, 262.0}, true, "wall_red"},
                                                   {{8.0, 29.0, 272.0}, false, "wall_yellow"},
                                                   {{5.0, 13.0, 255.0}, true, "wall_turquoise"},
                                                   {{22.0, 50.0, 300.0}, false, "wall_white"},
                                                   {{24.0, 34.0, 250.0}, true, "wall_orange"},
                                                   {{21.0, 17.0, 235.0}, false, "wall_blue"},
                                                   {{13.0, -1.0, 228.0}, true, "wall_pink"},
                                                   {{39.0, 25.0, 265.0}, true, "wall_green"}}};

inline constexpr Place kJetty = {-7.0, 27.0, 268.0};
inline constexpr Place kBoat = {-27.0, 30.6, 282.0};
inline constexpr Place kBeachedBoat = {-6.5, 44.0, 235.0};
inline constexpr std::array<Place, 3> kDriftwood = {{{-12.0, 67.0, 330.0}, {-13.0, -12.0, 80.0}, {28.0, 99.0, 10.0}}};

/// Palms that frame the view along the beach; they lean along the azimuth.
inline constexpr std::array<Place, 6> kFramingPalms = {{{-11.2, 60.5, 292.0},
                                                        {11.0, 61.0, 250.0},
                                                        {13.5, 64.5, 60.0},
                                                        {-2.5, 20.0, 262.0},
                                                        {-3.0, 37.5, 290.0},
                                                        {-1.0, 5.0, 250.0}}};
inline constexpr Place kWreck = {-28.5, -27.0, 130.0};

inline double radians(double degrees) {
  return degrees * kTau / 360.0;
}

/// Distance to the nearest trodden path.
double distanceToPath_m(double x, double z);

/// Distance to the nearest obstacle for plants and rocks: huts, the jetty, boats, the wreck, the cave's mouth. It is
/// negative inside.
double clearance_m(double x, double z);

/// Whether a plant or rock here would hide the village from the beach in the south.
bool isInView(double x, double z);

}  // namespace welkin::island
