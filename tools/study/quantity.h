// SPDX-License-Identifier: Apache-2.0
// Numbers as people read them: 1e-4 as 0.01 %, 1500 bytes as 1.5 KB, 2e-8 s as 20 ns.
#pragma once

#include <string>

namespace welkin::study {

/// The kind of a number, which decides how it is written.
enum class Quantity {
  number,   ///< as it is
  share,    ///< of 1, written in per cent
  bytes,    ///< B, KB, MB, GB by powers of 1000
  seconds,  ///< ns, us, ms, s
};

/// `value` with at most `digits` significant digits and its unit; the same for every locale.
std::string inWords(double value, Quantity quantity, int digits);

/// A share in words, with two digits.
inline std::string share(double value) {
  return inWords(value, Quantity::share, 2);
}

}  // namespace welkin::study
