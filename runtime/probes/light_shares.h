// SPDX-License-Identifier: Apache-2.0
// The share of each dynamic light, or lamp, that goes to virtual lights (probes/transfer/local_relight.h).
#pragma once

#include <welkin/level.h>

#include "probes/virtual_lights.h"

namespace welkin::probes {

inline constexpr std::size_t kMostShares = 32;  ///< virtual lights of a lamp

struct LightShare {
  LightHandle light;  ///< a first one; kNoLight where it has left
  float weight;       ///< the lamp's intensity times this goes to it
};

/// A lamp of the level and what became of it.
struct Lamp {
  WelkinPointLight light;
  std::uint32_t shares;
  std::uint32_t is_stale;  ///< 1: virtual lights near it came or went
  double reach_m;          ///< virtual lights beyond do not matter to it
  LightShare share[kMostShares];
};

/// A spot's cone as shaders/shared/punctual_light.glsl takes it.
struct Cone {
  double scale, offset;
  double part;  ///< share of the sphere's intensity that is within, in [0, 1]
};
Cone coneOf(const WelkinPointLight& light);

/// Test whether a virtual light and a lamp see each other; without a function they do.
struct Sight {
  WelkinSees sees = nullptr;
  void* user = nullptr;
};

/// Shares a lamp anew: `shares`, `share` and `reach_m`. No share if no virtual light sees it.
void shareLamp(const LightTable& table, const Sight& sight, Lamp& lamp);

}  // namespace welkin::probes
