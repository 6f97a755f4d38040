// SPDX-License-Identifier: Apache-2.0
// How many pictures a second the viewer draws, while the camera moves and when it is still.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "render/pass_times.h"

namespace welkin::view {

class Session;

struct Rates {
  double moving = 0.0, still = 0.0;                       ///< pictures a second, panels included
  std::size_t pictures = 0;                               ///< of each kind
  uint32_t width = 0, height = 0;                         ///< of the window, pixels
  std::vector<render::PassTime> moving_pass, still_pass;  ///< of the last picture of each kind
  uint32_t divisor = 1;                                   ///< a picture that moves has the window's size over this
};

/// Draws so many pictures of each kind, each with the camera turned by a degree, and shows them by the session's host.
/// One more of each comes first and is not counted. The state is afterwards as before.
Rates measureRates(Session& session, std::size_t pictures);

}  // namespace welkin::view
