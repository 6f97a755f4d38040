// SPDX-License-Identifier: Apache-2.0
#include "probes/obj/polygon.h"

#include <algorithm>
#include <cmath>
#include <deque>

namespace welkin::obj {
namespace {

using f64::Number3;
using Corners = std::array<std::size_t, 3>;

/// A vector along the polygon's normal, twice as long as its area (Newell).
Number3 newell(std::span<const Number3> polygon) {
  Number3 sum(0.0);
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return sum;
}

bool isFinite(const Number3& p) {
  return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// The corners that are left form a ring of links. An ear is a corner that turns with the polygon, and no other corner
/// lies in its triangle. Among the others, those that turn with the polygon need no test: a triangle with any corner
/// inside has one inside that does not (Eberly, "Triangulation by ear clipping", 2002). So a cut changes only its two
/// neighbours. Ears wait in a queue, which spreads the cuts around the polygon and keeps triangles small.
/// Rounding can hide an ear, so an empty queue is filled again, once each time that half of the corners are gone.
class Ears {
 public:
  explicit Ears(std::span<const Number3> polygon)
      : p_(polygon),
        normal_(newell(polygon)),
        axis_(longestAxis()),
        next_(polygon.size()),
        previous_(polygon.size()),
        changes_(polygon.size()),
        left_(polygon.size()) {
    const std::size_t n = polygon.size();
    for (std::size_t i = 0; i < n; ++i) {
      next_[i] = (i + 1) % n;
      previous_[next_[i]] = i;
    }
    for (std::size_t i = 0; i < n; ++i) is_inward_.push_back(!turnsWithPolygon(i));
    for (std::size_t i = 0; i < n; ++i)
      if (is_inward_[i]) inward_.push_back(i);
    std::sort(inward_.begin(), inward_.end(), [&](std::size_t a, std::size_t b) { return along(a) < along(b); });
    fillQueue();
  }

  std::vector<Corners> cut() {
    std::vector<Corners> triangles;
    std::size_t last = 0;
    while (triangles.size() + 2 < p_.size()) {
      const std::size_t ear = takeEar(last);
      Corners corners = cornersAt(ear);
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
      triangles.push_back(corners);
      last = next_[ear];
      remove(ear);
    }
    return triangles;
  }

 private:
  /// The axis along which the polygon is longest.
  int longestAxis() const {
    Number3 low = p_[0];
    Number3 high = p_[0];
    for (const Number3& p : p_)
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], p[i]);
        high[i] = std::max(high[i], p[i]);
      }
    const Number3 size = high - low;
    if (size.x >= size.y && size.x >= size.z) return 0;
    return size.y >= size.z ? 1 : 2;
  }

  double along(std::size_t i) const { return p_[i][axis_]; }

  Corners cornersAt(std::size_t i) const { return {previous_[i], i, next_[i]}; }

  double turn(std::size_t a, std::size_t b, std::size_t c) const {
    return dot(cross(p_[b] - p_[a], p_[c] - p_[a]), normal_);
  }

  bool turnsWithPolygon(std::size_t i) const { return turn(previous_[i], i, next_[i]) > 0.0; }

  bool isSamePlace(std::size_t a, std::size_t b) const {
    return p_[a].x == p_[b].x && p_[a].y == p_[b].y && p_[a].z == p_[b].z;
  }

  bool isEar(std::size_t i) const {
    const auto [a, b, c] = cornersAt(i);
    if (is_inward_[i]) return false;
    const auto [low, high] = std::minmax({along(a), along(b), along(c)});
    auto q = std::lower_bound(inward_.begin(), inward_.end(), low,
                              [&](std::size_t corner, double least) { return along(corner) < least; });
    for (; q != inward_.end() && along(*q) <= high; ++q)
      if (is_inward_[*q] && *q != a && *q != c && blocks(*q, a, b, c)) return false;
    return true;
  }

  /// Whether corner q lies in the triangle. A corner in the place of a or c does not: a hole is joined to its outline
  /// by an edge that the polygon follows twice.
  bool blocks(std::size_t q, std::size_t a, std::size_t b, std::size_t c) const {
    return turn(a, b, q) >= 0.0 && turn(b, c, q) >= 0.0 && turn(c, a, q) >= 0.0 && !isSamePlace(q, a) &&
           !isSamePlace(q, c);
  }

  bool isLeft(std::size_t i) const { return next_[previous_[i]] == i; }

  void addIfEar(std::size_t i) {
    if (isEar(i)) waiting_.push_back({i, changes_[i]});
  }

  /// The first corner waits last, so that a convex polygon of four corners is cut from its first one.
  void fillQueue() {
    fill_again_at_ = left_ / 2;
    for (std::size_t i = 1; i <= p_.size(); ++i)
      if (isLeft(i % p_.size())) addIfEar(i % p_.size());
  }

  /// The next ear. A polygon that is not simple may have none, and `otherwise` is cut then.
  std::size_t takeEar(std::size_t otherwise) {
    for (;;) {
      if (waiting_.empty() && left_ <= fill_again_at_) fillQueue();
      if (waiting_.empty()) return otherwise;
      const Waiting ear = waiting_.front();
      waiting_.pop_front();
      if (changes_[ear.corner] == ear.changes) return ear.corner;
    }
  }

  void remove(std::size_t i) {
    const std::size_t a = previous_[i];
    const std::size_t c = next_[i];
    next_[a] = c;
    previous_[c] = a;
    --left_;
    is_inward_[i] = false;
    for (const std::size_t changed : {a, i, c}) ++changes_[changed];
    for (const std::size_t neighbour : {a, c}) is_inward_[neighbour] = !turnsWithPolygon(neighbour);
    addIfEar(a);
    addIfEar(c);
  }

  struct Waiting {
    std::size_t corner;
    std::size_t changes;  // of its neighbours, when it began to wait
  };

  std::span<const Number3> p_;
  Number3 normal_;
  int axis_;
  std::vector<std::size_t> next_, previous_;
  std::vector<bool> is_inward_;      // of the corners that are left
  std::vector<std::size_t> inward_;  // all that were at the start, sorted along the axis
  std::vector<std::size_t> changes_;
  std::size_t left_;
  std::size_t fill_again_at_ = 0;
  std::deque<Waiting> waiting_;
};

std::vector<Corners> fanOf(std::size_t corners) {
  std::vector<Corners> triangles;
  for (std::size_t i = 2; i < corners; ++i) triangles.push_back({0, i - 1, i});
  return triangles;
}

}  // namespace

std::vector<Corners> trianglesOf(std::span<const Number3> polygon) {
  if (polygon.size() == 3 || !std::all_of(polygon.begin(), polygon.end(), isFinite)) return fanOf(polygon.size());
  return Ears(polygon).cut();
}

}  // namespace welkin::obj
