// SPDX-License-Identifier: Apache-2.0
#include "view/rates.h"

#include <chrono>

#include "view/session.h"

namespace welkin::view {

Rates measureRates(Session& session, std::size_t pictures) {
  const State before = session.state();
  Rates rates;
  rates.pictures = pictures;
  rates.width = session.width();
  rates.height = session.height();
  const auto measured = [&](bool quick) {
    session.setHurry(quick);
    auto begin = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i <= pictures; ++i) {
      State state = session.state();
      state.eye.yaw_deg = before.eye.yaw_deg + static_cast<double>(i);
      session.set(state);
      session.host().show(session.picture(quick));
      if (i == 0) begin = std::chrono::steady_clock::now();
    }
    session.setHurry(false);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return static_cast<double>(pictures) / seconds;
  };
  rates.moving = measured(true);
  rates.moving_pass = session.passTimes();
  rates.divisor = session.quickDivisor();
  rates.still = measured(false);
  rates.still_pass = session.passTimes();
  session.set(before);
  return rates;
}

}  // namespace welkin::view
