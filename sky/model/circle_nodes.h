// SPDX-License-Identifier: Apache-2.0
// Sums over the nodes of a circle of one latitude against the cosines of multiples of their angle.
#pragma once

#include <span>

#include "sh/deterministic.h"

namespace welkin::model {

using det::Number3;

/// Nodes of a circle. The cosines of their multiples are taken for two nodes side by side, and four orders are summed
/// at once, since each sum has to wait for its previous term.
class CircleNodes {
 public:
  bool isFull() const { return count_ == kMost; }
  void add(const Number3& shape, double cosine) {
    shape_[count_] = shape;
    cosine_[count_++] = cosine;
  }
  /// Adds every node to the integrals against cos(m alpha), and forgets them.
  void addTo(std::span<Number3> order) {
    if (count_ % 2 == 1) add(Number3(0.0), 1.0);  // adds nothing
    Number2 twice[kMost / 2];
    Number2 before[kMost / 2];
    Number2 current[kMost / 2];
    for (std::size_t i = 0; i < count_ / 2; ++i) {
      before[i] = Number2{cosine_[2 * i], cosine_[2 * i + 1]};
      twice[i] = 2.0 * before[i];
      current[i] = Number2{1.0, 1.0};
    }
    for (std::size_t m = 0; m < order.size(); m += 4) {
      Sums low(order, m);
      Sums high(order, m + 2);
      for (std::size_t i = 0; i < count_ / 2; ++i) {  // as sh/multiple_cosines.h
        const Number2 first = current[i];
        const Number2 second = twice[i] * first - before[i];
        const Number2 third = twice[i] * second - first;
        const Number2 fourth = twice[i] * third - second;
        before[i] = fourth;
        current[i] = twice[i] * fourth - third;
        for (const int k : {0, 1}) {
          const Number3& shape = shape_[2 * i + static_cast<std::size_t>(k)];
          low.add(shape, Number2{first[k], second[k]});
          high.add(shape, Number2{third[k], fourth[k]});
        }
      }
      low.store(order, m);
      high.store(order, m + 2);
    }
    count_ = 0;
  }

 private:
  using Number2 = det::Number2;
  /// The integrals of orders m and m + 1, by channel. Orders past the last are not kept.
  struct Sums {
    Number2 x{}, y{}, z{};

    Sums(std::span<const Number3> order, std::size_t m) {
      for (std::size_t k = 0; k < 2 && m + k < order.size(); ++k) {
        x[k] = order[m + k].x;
        y[k] = order[m + k].y;
        z[k] = order[m + k].z;
      }
    }
    void add(const Number3& shape, Number2 cosines) {
      x += shape.x * cosines;
      y += shape.y * cosines;
      z += shape.z * cosines;
    }
    void store(std::span<Number3> order, std::size_t m) const {
      for (std::size_t k = 0; k < 2 && m + k < order.size(); ++k) order[m + k] = {x[k], y[k], z[k]};
    }
  };

  static constexpr std::size_t kMost = 64;
  std::size_t count_ = 0;
  Number3 shape_[kMost];
  double cosine_[kMost];
};

}  // namespace welkin::model
