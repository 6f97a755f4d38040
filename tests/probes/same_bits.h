// SPDX-License-Identifier: Apache-2.0
// Compares traced probes to the last bit.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "probes/transfer/local_transfer.h"
#include "probes/transfer/transfer.h"

namespace welkin::tests {

template <typename T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof a[0]) == 0);
}

inline bool sameBits(const transfer::TracedProbe& a, const transfer::TracedProbe& b) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return same(a.transfer.visibility, b.transfer.visibility) && same(a.transfer.sky, b.transfer.sky) &&
         same(a.transfer.emitted, b.transfer.emitted) && same(a.effort, b.effort) &&
         std::equal(a.transfer.sun.begin(), a.transfer.sun.end(), b.transfer.sun.begin(),
                    [](const auto& x, const auto& y) { return sameBits(x, y); });
}

inline bool sameBits(const transfer::LocalProbe& a, const transfer::LocalProbe& b) {
  return a.error == b.error && a.paths == b.paths && a.rays == b.rays && sameBits(a.standard_error, b.standard_error) &&
         std::equal(a.transfer.begin(), a.transfer.end(), b.transfer.begin(), b.transfer.end(),
                    [](const transfer::LocalTransfer& x, const transfer::LocalTransfer& y) {
                      return x.light == y.light && std::memcmp(&x.radiance, &y.radiance, sizeof x.radiance) == 0;
                    });
}

}  // namespace welkin::tests
