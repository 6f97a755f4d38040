// SPDX-License-Identifier: Apache-2.0
#include "sh/arithmetic.h"

#include <limits>

namespace welkin::sh {

const char* whyArithmeticDiffers() {
  // volatile: the processor computes this here, not the compiler. On x86-64 std::fegetround reports the x87's mode.
  volatile double one = 1.0;
  volatile double most_of_ulp = 0.75 * std::numeric_limits<double>::epsilon();
  volatile double little_of_ulp = 0.25 * std::numeric_limits<double>::epsilon();
  volatile double smallest = std::numeric_limits<double>::min();
  volatile double denormal = std::numeric_limits<double>::denorm_min();
  volatile double large = 0x1p1000;
  if (!(one + most_of_ulp > one && one + little_of_ulp == one && -one - little_of_ulp == -one))
    return "the processor does not round to nearest";
  if (!(smallest / 2.0 * large > 0.0 && denormal * large > 0.0)) return "the processor takes denormal numbers for zero";
  return nullptr;
}

}  // namespace welkin::sh
