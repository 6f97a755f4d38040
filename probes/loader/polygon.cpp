// SPDX-License-Identifier: Apache-2.0
#include "probes/loader/polygon.h"

#include <algorithm>
#include <numeric>

namespace welkin::loader {
namespace {

using f64::Number3;

/// A vector along the polygon's normal, twice as long as its area (Newell).
Number3 newell(std::span<const Number3> polygon) {
  Number3 sum(0.0);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return sum;
}

class Ears {
 public:
  explicit Ears(std::span<const Number3> polygon) : p_(polygon), normal_(newell(polygon)), left_(polygon.size()) {
    std::iota(left_.begin(), left_.end(), std::size_t{0});
  }

  std::vector<std::array<std::size_t, 3>> cut() {
    std::vector<std::array<std::size_t, 3>> triangles;
    while (left_.size() > 3) {
      std::size_t best = 0;
      while (best < left_.size() && !isEar(best)) ++best;
      if (best == left_.size()) best = 0;  // the polygon is not simple
      triangles.push_back(corners(best));
      left_.erase(left_.begin() + static_cast<std::ptrdiff_t>((best + 1) % left_.size()));
    }
    triangles.push_back({left_[0], left_[1], left_[2]});
    return triangles;
  }

 private:
  /// The triangle whose second corner may be cut off.
  std::array<std::size_t, 3> corners(std::size_t i) const {
    return {left_[i], left_[(i + 1) % left_.size()], left_[(i + 2) % left_.size()]};
  }

  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    return dot(cross(p_[b] - p_[a], p_[c] - p_[a]), normal_);
  }

  bool isEar(std::size_t i) const {
    const auto [a, b, c] = corners(i);
    if (!(turn(a, b, c) > 0.0)) return false;
    return std::none_of(left_.begin(), left_.end(), [&, a = a, b = b, c = c](std::size_t q) {
      return q != a && q != b && q != c && turn(a, b, q) >= 0.0 && turn(b, c, q) >= 0.0 && turn(c, a, q) >= 0.0;
    });
  }

  std::span<const Number3> p_;
  Number3 normal_;
  std::vector<std::size_t> left_;
};

}  // namespace

std::vector<std::array<std::size_t, 3>> trianglesOf(std::span<const Number3> polygon) {
  return Ears(polygon).cut();
}

}  // namespace welkin::loader
