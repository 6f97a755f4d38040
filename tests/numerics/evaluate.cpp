// SPDX-License-Identifier: Apache-2.0
#include "evaluate.h"

#include <fmt/format.h>

#include <sstream>

#include "body.h"
#include "materials.h"
#include "tests/stress/random.h"

// NOLINTBEGIN(bugprone-macro-parentheses)
#define NUMBER(literal) Number(literal)
#define LuminanceModel(...) \
  LuminanceModel {          \
    __VA_ARGS__             \
  }
#define PUT(name, size_, arguments_, value_) put(#name, arguments_, Number(size_), Number(value_));
#define PUT3(name, size_, arguments_, value_)                                \
  {                                                                          \
    const Number3 v = value_;                                                \
    for (int c = 0; c < 3; ++c) put(#name, arguments_, Number(size_), v[c]); \
  }
#define WELKIN_EVALUATE                                                                                           \
  template <typename Put>                                                                                         \
  void evaluate(std::span<const float> p, Put&& put) {                                                            \
    const auto vector = [&](std::size_t i) { return Number3(Number(p[i]), Number(p[i + 1]), Number(p[i + 2])); }; \
    const Number3 a = vector(0);                                                                                  \
    const Number azimuth_rad = Number(p[3]);                                                                      \
    const Number3 b = vector(4);                                                                                  \
    const Number angle_rad = Number(p[7]);                                                                        \
    const Number3 near_b = vector(8);                                                                             \
    const Number x = Number(p[11]);                                                                               \
    const Number3 rgb = vector(12);                                                                               \
    const Number up = Number(p[15]);                                                                              \
    const Number theta = Number(p[16]);                                                                           \
    const Number s = Number(p[17]);                                                                               \
    const Number t = Number(p[18]);                                                                               \
    WELKIN_NUMERICS_BODY                                                                                          \
  }
// NOLINTEND(bugprone-macro-parentheses)

namespace welkin::f32 {
namespace {
WELKIN_EVALUATE
}
}  // namespace welkin::f32

namespace welkin::f64 {
namespace {
WELKIN_EVALUATE
}
}  // namespace welkin::f64

#undef NUMBER
#undef LuminanceModel
#undef PUT
#undef PUT3

namespace welkin::numerics {
namespace {

using f64::Number3;

auto into(Values& out) {
  out.value.clear();
  out.size.clear();
  return [&out](const char*, const char*, auto size, auto value) {
    out.value.push_back(static_cast<double>(value));
    out.size.push_back(static_cast<double>(size));
  };
}

Number3 drawDirection(stress::Random& random) {
  const double azimuth = random.between(0.0, f64::kTwoPi);
  const double small = random.magnitude(1e-9, 0.1) * (random.once(2) ? 1.0 : -1.0);
  const int place = random.below(8);
  const double elevation = place == 0   ? small
                           : place == 1 ? f64::kHalfPi - std::abs(small)
                           : place == 2 ? std::abs(small) - f64::kHalfPi
                                        : std::asin(random.between(-1.0, 1.0));
  return f64::directionOf(random.once(16) ? f64::kHalfPi * random.below(4) : azimuth, elevation);
}

/// A unit direction at a small angle from another.
Number3 beside(stress::Random& random, const Number3& d, double angle) {
  Number3 across = cross(d, drawDirection(random));
  const double length = std::sqrt(dot(across, across));
  return length > 1e-3 ? d * std::cos(angle) + across * (std::sin(angle) / length) : d;
}

}  // namespace

const std::vector<Slot>& slots() {
  static const std::vector<Slot> kSlots = [] {
    std::vector<Slot> list;
    const std::vector<float> arguments = drawArguments(0, 1);
    f64::evaluate(arguments, [&](const char* name, const char* which, double, double) {
      list.push_back({name, which});
    });
    return list;
  }();
  return kSlots;
}

void evaluateAsFloats(std::span<const float> arguments, Values& out) {
  f32::evaluate(arguments, into(out));
}

void evaluateAsDoubles(std::span<const float> arguments, Values& out) {
  f64::evaluate(arguments, into(out));
}

std::vector<float> drawArguments(std::size_t first, std::size_t count) {
  std::vector<float> all;
  all.reserve(count * WELKIN_NUMERICS_ARGUMENTS);
  for (std::size_t i = first; i < first + count; ++i) {
    stress::Random random(5, i);
    const Number3 a = drawDirection(random);
    const Number3 b = random.once(2) ? drawDirection(random) : beside(random, a, random.magnitude(1e-9, 1.0));
    const Number3 near_b = beside(random, b, 0.0047 * std::sqrt(random.unit()));
    const double dark = random.once(2) ? 1.0 : random.magnitude(1e-9, 1.0);
    const auto unitOrEdge = [&] {
      return random.once(32) ? double(random.below(2)) : random.once(4) ? random.magnitude(1e-9, 1.0) : random.unit();
    };
    for (const double v : {a.x,
                           a.y,
                           a.z,
                           random.between(-f64::kPi, f64::kPi),
                           b.x,
                           b.y,
                           b.z,
                           random.once(4) ? random.magnitude(1e-9, 1.0) : random.between(-f64::kHalfPi, f64::kHalfPi),
                           near_b.x,
                           near_b.y,
                           near_b.z,
                           -random.magnitude(1e-9, 80.0),
                           dark * random.unit(),
                           dark * random.unit(),
                           dark * random.unit(),
                           random.once(2) ? random.between(1e-9, 1.0) : random.magnitude(1e-9, 1.0),
                           random.once(4) ? random.magnitude(1e-9, 1.0) : random.between(0.0, f64::kPi),
                           unitOrEdge(),
                           unitOrEdge(),
                           0.0})
      all.push_back(static_cast<float>(v));
  }
  return all;
}

std::string describe(const Slot& slot, std::span<const float> p) {
  std::istringstream names(slot.arguments);
  std::string text;
  for (std::string name; names >> name;) {
    if (!text.empty()) text += ", ";
    const auto vector = [&](std::size_t i) {
      return fmt::format("{} ({:.6g}, {:.6g}, {:.6g})", name, p[i], p[i + 1], p[i + 2]);
    };
    const auto number = [&](const char* word, std::size_t i) { return fmt::format("{} {:.6g}", word, p[i]); };
    text += name == "a"       ? vector(0)
            : name == "b"     ? vector(4)
            : name == "near"  ? vector(8)
            : name == "rgb"   ? vector(12)
            : name == "az"    ? number("azimuth", 3)
            : name == "el"    ? number("angle", 7)
            : name == "x"     ? number("x", 11)
            : name == "y"     ? number("cosine", 15)
            : name == "theta" ? number("theta", 16)
                              : number(name.c_str(), name == "s" ? 17 : 18);
  }
  return text;
}

}  // namespace welkin::numerics
