// SPDX-License-Identifier: Apache-2.0
#include "draw.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "sky/bake/sky_domain.h"
#include "sky/model/luminance.h"

namespace welkin::stress {
namespace {

using base::Kind;
using base::Parameter;
using base::Range;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMostKeys = 4;

/// Up to kMostKeys whole seconds of a day, ascending, in hours. Midnight, noon and the day's last second come more
/// often than by chance.
std::vector<double> drawTimes(Random& random) {
  std::set<int> seconds;
  for (int i = random.below(kMostKeys); i >= 0; --i)
    seconds.insert(random.once(6) ? 0 : random.once(6) ? 86399 : random.once(6) ? 43200 : random.below(86400));
  if (random.once(6)) seconds.insert(std::min(*seconds.begin() + 1, 86399));
  std::vector<double> times;
  for (const int second : seconds) times.push_back(second / 3600.0);
  return times;
}

template <typename Value>
std::string drawKeys(Random& random, Value&& value) {
  std::string text;
  for (const double time_h : drawTimes(random))
    text += fmt::format("{}[{}, {}]", text.empty() ? "" : ", ", time_h, value());
  return "[" + text + "]";
}

/// Coefficients of a named model, moved a little, or any of the domain.
std::string drawCoefficients(Random& random) {
  const auto& named = model::namedLuminances();
  const model::LuminanceModel& m = named[static_cast<std::size_t>(random.below(static_cast<int>(named.size())))].model;
  double value[5] = {m.a, m.b, m.c, m.d, m.e};
  std::string text;
  for (std::size_t i = 0; i < 5; ++i) {
    const Range& range =
        base::parameterOf(bake::skyDomain(), "sky", "luminance", std::string_view("abcde").substr(i, 1)).range;
    double v = value[i] * (random.once(2) ? 1.0 : random.magnitude(0.5, 2.0));
    if (random.once(4)) v = drawNumber(random, range);
    text += fmt::format("{}{}", i == 0 ? "" : ", ", range.contains(v) ? v : value[i]);
  }
  return "[" + text + "]";
}

std::string drawColour(Random& random, const Range& range) {
  if (random.once(4)) {
    const double grey = drawNumber(random, range);
    return fmt::format("[{0}, {0}, {0}]", grey);
  }
  const double r = drawNumber(random, range);
  const double g = drawNumber(random, range);
  return fmt::format("[{}, {}, {}]", r, g, drawNumber(random, range));
}

std::string drawWord(Random& random, const Parameter& p) {
  return fmt::format("\"{}\"", p.words[static_cast<std::size_t>(random.below(static_cast<int>(p.words.size())))]);
}

/// A value of the parameter's kind.
std::string drawValue(Random& random, const Parameter& p) {
  const auto number = [&] { return fmt::format("{}", drawNumber(random, p.range)); };
  const auto colour = [&] { return drawColour(random, p.range); };
  switch (p.kind) {
    case Kind::number:
      return number();
    case Kind::whole_number:
      return fmt::format("{}", std::floor(drawNumber(random, p.range)));
    case Kind::word:
      return drawWord(random, p);
    case Kind::colour:
    case Kind::gradient:
      return colour();
    case Kind::number_or_keys:
      return random.once(2) ? number() : drawKeys(random, number);
    case Kind::colour_or_keys:
    case Kind::tint:
      return random.once(2) ? colour() : drawKeys(random, colour);
    case Kind::luminance:
      return random.once(2) ? drawWord(random, p) : drawCoefficients(random);
    case Kind::path: {
      std::string text;
      for (const double time_h : drawTimes(random))
        text += fmt::format(
            "{}[{}, {}, {}]", text.empty() ? "" : ", ", time_h,
            drawNumber(random, base::parameterOf(bake::skyDomain(), p.section, p.key, "azimuth_deg").range),
            random.once(4)
                ? 0.0
                : drawNumber(random, base::parameterOf(bake::skyDomain(), p.section, p.key, "elevation_deg").range));
      return "[" + text + "]";
    }
    case Kind::hours: {
      if (random.once(2)) return fmt::format("{}", 1 + random.below(kMostKeys));
      std::string text;
      for (const double time_h : drawTimes(random)) text += fmt::format("{}{}", text.empty() ? "" : ", ", time_h);
      return "[" + text + "]";
    }
    case Kind::image:
      return "\"stars.ppm\"";
    default:  // parts, and kinds that only a level file has
      break;
  }
  return {};
}

/// Whether the drawn section has this key. A section drawn `by_hand` has a path and no key that excludes one.
bool isDrawn(Random& random, const Parameter& p, bool by_hand) {
  if (p.kind == Kind::part || (by_hand && p.without_path)) return false;
  if (p.key == "path") return by_hand;
  if (p.section == "bake" && p.key == "keys") return true;  // "auto" makes more keys than there is time for
  return std::holds_alternative<base::Required>(p.otherwise) || p.key == "latitude_deg" || random.once(2);
}

}  // namespace

double drawNumber(Random& random, const Range& range) {
  if (random.once(4)) {
    const int end = random.below(4);
    const double highest = range.without_high ? std::nextafter(range.high, -kInfinity) : range.high;
    return end == 0   ? range.low
           : end == 1 ? std::nextafter(range.low, kInfinity)
           : end == 2 ? highest
                      : std::nextafter(highest, -kInfinity);
  }
  const double largest = std::max(std::abs(range.low), std::abs(range.high));
  if (largest <= 400.0 && random.once(2)) return random.between(range.low, range.high);
  const double size = random.magnitude(1e-18 * largest, largest);
  const bool negative = range.high <= 0.0 || (range.low < 0.0 && random.once(2));
  return std::clamp(negative ? -size : size, range.low, range.high);
}

det::Number3 drawDirection(Random& random) {
  const double azimuth = random.between(0.0, det::kTwoPi);
  if (random.once(4)) {
    const double near = random.once(3) ? 0.0 : random.magnitude(1e-18, 0.1) * (random.once(2) ? -1.0 : 1.0);
    return det::directionOf(azimuth, near + (random.once(2) ? 0.0 : random.once(2) ? det::kHalfPi : -det::kHalfPi));
  }
  const double y = random.between(-0.5, 1.0);
  const double r = std::sqrt(1.0 - y * y);
  return {r * std::sin(azimuth), y, -r * std::cos(azimuth)};
}

std::string drawSkyFile(Random& random) {
  std::string text;
  std::string_view section;
  bool drawn = false;
  bool by_hand = false;
  for (const Parameter& p : bake::skyDomain()) {
    if (p.section.empty()) continue;
    if (p.section != section) {
      section = p.section;
      drawn = section == "sky" || section == "sun" || section == "bake" || random.once(section == "moon" ? 3 : 8);
      by_hand = random.once(2);
      if (drawn) text += fmt::format("[{}]\n", section);
    }
    if (drawn && isDrawn(random, p, by_hand)) text += fmt::format("{} = {}\n", p.key, drawValue(random, p));
  }
  return text;
}

model::Gradient drawGradient(Random& random) {
  model::Gradient gradient{1 + random.below(4), 1 + random.below(4), {}};
  const bool wide = random.once(2);
  for (int i = 0; i < gradient.width * gradient.height; ++i) {
    const bool black = random.once(8);
    for (int c = 0; c < 3; ++c)
      gradient.rgb.push_back(black || random.once(8) ? 0.0F
                             : wide                  ? static_cast<float>(random.magnitude(1e-30, 1e30))
                                                     : static_cast<float>(random.unit()));
  }
  return gradient;
}

}  // namespace welkin::stress
