// SPDX-License-Identifier: Apache-2.0
// What the tests of local transfer share.
#pragma once

#include "probes/transfer/local_transfer.h"
#include "rooms.h"
#include "transfer_helpers.h"

namespace welkin::tests {

/// Of a quantity of `count` probes with their own random numbers at one place.
template <typename Quantity>
Measured measuredLocal(const probes::LocalTransferTracer& tracer, const Number3& position, std::size_t count,
                       const Quantity& quantity) {
  double sum = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double value = quantity(tracer.trace(position, {3, -2}, i));
    sum += value;
    squares += value * value;
  }
  const double n = static_cast<double>(count);
  const double mean = sum / n;
  return {mean, std::sqrt(std::max(squares / n - mean * mean, 0.0) / (n - 1.0))};
}

/// The transfer of a light, or none.
inline probes::LocalTransfer of(const probes::LocalProbe& probe, std::uint32_t light) {
  for (const probes::LocalTransfer& t : probe.transfer)
    if (t.light == light) return t;
  return {light, {}};
}

/// A room with a pillar, open to one side, walls of three colours.
inline probes::Surfaces furnishedRoom() {
  probes::Surfaces s;
  addBoxInside(s, {-5, 0, -4}, {5, 4, 4}, addMaterial(s, {0.7, 0.5, 0.3}));
  addBoxOutside(s, {0.5, 0, -1.5}, {1.2, 4, 1}, addMaterial(s, {0.2, 0.6, 0.8}));
  addQuad(s, {-5, 1, -4}, {0, 0, 8}, {2, 0, 0}, addMaterial(s, {0.9, 0.1, 0.4}, true));
  return s;
}

}  // namespace welkin::tests
