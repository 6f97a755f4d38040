// SPDX-License-Identifier: Apache-2.0
// cos(m a) for m = 0, 1, 2, ... from cos(a): Chebyshev's recurrence cos (m + 1) a = 2 cos a cos m a - cos (m - 1) a.
#pragma once

namespace welkin::sh {

class MultipleCosines {
 public:
  explicit MultipleCosines(double cosine) : cosine_(cosine), before_(cosine) {}

  double value() const { return current_; }
  void advance() {
    const double next = 2.0 * cosine_ * current_ - before_;
    before_ = current_;
    current_ = next;
  }

 private:
  double cosine_;
  double before_;
  double current_ = 1.0;
};

}  // namespace welkin::sh
