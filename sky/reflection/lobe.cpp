// SPDX-License-Identifier: Apache-2.0
#include "sky/reflection/lobe.h"

#include <algorithm>
#include <cmath>

namespace welkin::reflection {

double glossOfMip(int mip, int mips) {
  return 1.0 - static_cast<double>(mip) / (mips - 1);
}

int mipsOfSize(int size) {
  int mips = 1;
  for (; size > 1; size /= 2) ++mips;
  return mips;
}

double lobeWeight(double power, double cosine) {
  return cosine > 0.0 ? det::pow(0.5 + 0.5 * cosine, 0.5 * power) * cosine : 0.0;
}

double lobeIntegral(double power) {
  const double p = 0.5 * power;
  const auto part = [](double q) { return (1.0 - det::pow(2.0, -q)) / q; };
  return 2.0 * det::kTwoPi * (2.0 * part(p + 2.0) - part(p + 1.0));
}

LobeSlopes lobeSlopes(double power, double cosine) {
  const double p = 0.5 * power, x = 0.5 + 0.5 * cosine;
  const double last = det::pow(x, p - 1.0);
  return {last * x * cosine, 0.5 * p * last * cosine + last * x, 0.25 * p * (p - 1.0) * last / x * cosine + p * last};
}

double lobeWidth(double power) {
  return 2.0 / std::sqrt(power);
}

double lobeReach(double power, double share) {
  return std::max(2.0 * det::pow(share, 2.0 / power) - 1.0, 0.0);
}

}  // namespace welkin::reflection
