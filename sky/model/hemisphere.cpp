// SPDX-License-Identifier: Apache-2.0
#include "sky/model/hemisphere.h"

#include <algorithm>

#include "sky/model/circle_nodes.h"

namespace welkin::model {
namespace {

constexpr double kRatio = 3.0;       // Ratio of neighbouring panels that shrink towards a cusp or a layer.
constexpr double kThinnest = 1e-16;  // Thinnest layer, radians.

/// sin 10 degrees is the cosine of the elevation at which the blend over azimuth starts to fade.
const double kFadeElevation = 80.0 / 180.0 * det::kPi;

/// Number of nodes of a panel. Gauss's error falls by a constant factor with each node; more bands turn faster.
struct Nodes {
  int coarse, middle, fine, azimuth;
  double smallest_h;
};
Nodes nodesFor(double tolerance, int orders) {
  Nodes nodes = tolerance >= 1e-4   ? Nodes{2, 3, 5, 5, 3e-3}
                : tolerance >= 1e-5 ? Nodes{2, 4, 6, 7, 1e-3}
                : tolerance >= 1e-9 ? Nodes{5, 8, 12, 12, 3e-4}
                                    : Nodes{9, 14, 22, 22, 3e-5};
  if (orders > 3) {
    ++nodes.middle;
    ++nodes.fine;
    ++nodes.azimuth;
  }
  // A panel may be a quarter circle, over which cos(m alpha) turns m / 4 times. That takes three nodes a turn, plus the
  // nodes for the sky's own change.
  nodes.azimuth = std::max(nodes.azimuth, 4 + 3 * orders / 4);
  return nodes;
}

/// Luminance of the darker of two gradient colours relative to the brighter, bounded below by the level where colours
/// are neutral.
double darknessOf(const Number3& darker, const Number3& brighter) {
  return std::max(det::luminanceOf(darker), kGradientDelta) / std::max(det::luminanceOf(brighter), kGradientDelta);
}

// From this ratio on, panels are as small as a pole of the hue demands, both between rows and between the gradients.
constexpr double kDark = 0.25;

/// The least distance between a pole of the hue and its rows. A texel's hue goes as 1 / luminance.
double hueScaleOf(const GradientColumn& column) {
  double scale = det::kHalfPi;
  for (std::size_t j = 1; j < column.row.size(); ++j) {
    const Number3& a = column.row[j - 1];
    const Number3& b = column.row[j];
    if (a == b) continue;
    const double ratio = std::min(darknessOf(a, b), darknessOf(b, a));
    const double reach = det::kHalfPi / static_cast<double>(column.row.size());
    scale = std::min(scale, reach * ratio / std::max(1.0 - ratio, 1e-3));
  }
  return scale;
}

bool hasDarkRows(const GradientColumn& column) {
  for (std::size_t j = 1; j < column.row.size(); ++j)
    if (darknessOf(column.row[j - 1], column.row[j]) < kDark || darknessOf(column.row[j], column.row[j - 1]) < kDark)
      return true;
  return false;
}

/// Returns 1 unless the other gradient is much brighter.
double darkSide(const Number3& darker, const Number3& brighter) {
  const double ratio = darknessOf(darker, brighter);
  return ratio < kDark ? ratio : 1.0;
}

double cuspScale(const LuminanceModel& m) {
  return 1.0 / std::max(1.0, -m.d);
}

}  // namespace

SunFrame::SunFrame(const SkyInstant& instant_, const IndicatrixTable* table_)
    : instant(instant_),
      table(table_),
      elevation(det::elevationOf(instant_.sunDirection())),
      half_sine(det::sin(0.5 * elevation)),
      half_cosine(det::cos(0.5 * elevation)),
      length(det::horizontalLength(instant_.sunDirection())),
      has_dark_rows(HemisphereQuadrature::fades(instant_) || hasDarkRows(instant_.sunColumn()) ||
                    hasDarkRows(instant_.antiColumn())),
      hue_scale(std::min(hueScaleOf(instant_.sunColumn()), hueScaleOf(instant_.antiColumn()))) {
  const Number3 at_sun = instant.sunColumn().at(kFadeElevation);
  const Number3 opposite = instant.antiColumn().at(kFadeElevation);
  dark_side = std::min(darkSide(at_sun, opposite), darkSide(opposite, at_sun));
}

HemisphereQuadrature::HemisphereQuadrature(double tolerance, int orders, double d) {
  constexpr double kSteep = 16.0;
  const Nodes nodes = nodesFor(tolerance, orders);
  smallest_h_ = nodes.smallest_h * (kSteep / std::max(-d, kSteep));
  coarse_ = sh::gaussLegendre(nodes.coarse);
  middle_ = sh::gaussLegendre(nodes.middle);
  fine_ = sh::gaussLegendre(nodes.fine);
  azimuth_ = sh::gaussLegendre(nodes.azimuth);
  dark_ = sh::gaussLegendre(nodes.fine + 2);
  dark_azimuth_ = sh::gaussLegendre(nodes.azimuth + 2);
}

std::vector<double> HemisphereQuadrature::panels(const SunFrame& frame, std::span<const double> extra) const {
  const SkyInstant& instant = frame.instant;
  const LuminanceModel& m = instant.sky().luminance;
  const double sun = frame.elevation;
  std::vector<double> edge(extra.begin(), extra.end());
  edge.push_back(kFadeElevation);
  double least = 1e-12;  // Thinner panels are only rounding.
  if (m.a != 0.0) {
    // Below it exp(-40) of the layer is left. The darkest zenith, 1e-9, hides all but 1e-7 of the part below kThinnest.
    const double layer = std::max(-m.b / 40.0, kThinnest);
    least = std::min(least, 0.5 * layer);
    for (double e = det::kHalfPi / kRatio; e > layer; e /= kRatio) edge.push_back(e);
  }
  const auto approach = [&](double centre, double scale) {
    edge.push_back(centre);
    for (double r = det::kHalfPi; r > 0.02 * scale; r /= kRatio) {
      edge.push_back(centre - r);
      edge.push_back(centre + r);
    }
  };
  if (m.c != 0.0) {
    approach(sun, cuspScale(m));
    if (sun < 0.1) approach(-sun, 4.0);  // the cusp at the antipode is exp(d pi) weaker
  }
  for (const GradientColumn* column : {&instant.sunColumn(), &instant.antiColumn()})
    for (int j = 0; j < static_cast<int>(column->row.size()); ++j)
      if (column->bendsAt(j)) edge.push_back(column->centre(j));
  // Above it the brighter gradient reaches the darker side. The hue turns as soon as its share is as bright.
  for (double r = frame.dark_side; r < 1.0; r *= kRatio)
    edge.push_back(kFadeElevation + r * (det::kHalfPi - kFadeElevation));
  if (frame.has_dark_rows)
    for (const GradientColumn* column : {&instant.sunColumn(), &instant.antiColumn()}) addDarkRows(*column, edge);

  const auto tidy = [&] {
    std::erase_if(edge, [&](double e) { return !(e > least && e < det::kHalfPi - 1e-12); });
    edge.push_back(0.0);
    edge.push_back(det::kHalfPi);
    std::sort(edge.begin(), edge.end());
    edge.erase(std::unique(edge.begin(), edge.end(), [&](double a, double b) { return b - a < least; }), edge.end());
  };
  tidy();
  addFadeCrossings(frame, edge);
  tidy();
  return edge;
}

std::size_t HemisphereQuadrature::addOrders(const SunFrame& sun, const Latitude& at, std::span<Number3> order) const {
  std::size_t evaluations = 0;
  double storage[1];
  CircleNodes nodes;
  forEachAzimuth(at, fadeCrossing(at, storage), [&](const Azimuth& azimuth) {
    nodes.add(shapeOn(sun, at, azimuth) * azimuth.weight, azimuth.cosine);
    if (nodes.isFull()) nodes.addTo(order);
    ++evaluations;
  });
  nodes.addTo(order);
  return evaluations;
}

void HemisphereQuadrature::addDarkRows(const GradientColumn& column, std::vector<double>& edge) {
  for (int j = 1; j < static_cast<int>(column.row.size()); ++j)
    for (const int side : {0, 1}) {
      const int dark = j - 1 + side;
      const int bright = j - side;
      const double ratio =
          darknessOf(column.row[static_cast<std::size_t>(dark)], column.row[static_cast<std::size_t>(bright)]);
      if (ratio >= kDark) continue;
      const double reach = column.centre(bright) - column.centre(dark);
      for (double r = ratio; r < 1.0; r *= kRatio) edge.push_back(column.centre(dark) + r * reach);
    }
}

bool HemisphereQuadrature::fades(const SkyInstant& instant) {
  const auto dark = [](const GradientColumn& column) {
    return std::any_of(column.row.begin(), column.row.end(),
                       [](const Number3& c) { return det::luminanceOf(c) < kGradientDelta; });
  };
  return dark(instant.sunColumn()) || dark(instant.antiColumn());
}

void HemisphereQuadrature::addFadeCrossings(const SunFrame& sun, std::vector<double>& edge) {
  // Luminance of the blended colour at the sun's azimuth and at the opposite one, minus the luminance where colours
  // fade.
  const auto excess = [&](double elevation, double cos_alpha) {
    const Latitude at = latitude(sun, elevation, 1.0);
    const double w = 0.5 + 0.5 * at.blend * cos_alpha;
    return det::luminanceOf(mix(at.anti_colour, at.sun_colour, w)) - kGradientDelta;
  };
  if (!fades(sun.instant)) return;
  const std::vector<double> before = edge;
  for (std::size_t i = 1; i < before.size(); ++i)
    for (const double side : {-1.0, 1.0}) {
      double low = before[i - 1];
      double high = before[i];
      const bool starts = excess(low, side) > 0.0;
      if (starts == (excess(high, side) > 0.0)) continue;
      for (int k = 0; k < 50; ++k) {
        const double middle = 0.5 * (low + high);
        ((excess(middle, side) > 0.0) == starts ? low : high) = middle;
      }
      // From here the share of the circles that has crossed grows as a square root.
      const double crossing = 0.5 * (low + high);
      edge.push_back(crossing);
      const double width = before[i] - before[i - 1];
      for (double r = width / kRatio; r > 0.02 * width; r /= kRatio)
        for (const double e : {crossing - r, crossing + r})
          if (e > before[i - 1] && e < before[i]) edge.push_back(e);
    }
}

std::span<const double> HemisphereQuadrature::fadeCrossing(const Latitude& at, double (&storage)[1]) {
  const double sun = det::luminanceOf(at.sun_colour);
  const double anti = det::luminanceOf(at.anti_colour);
  if ((sun < kGradientDelta) == (anti < kGradientDelta) || !(at.blend > 0.0)) return {};
  const double weight = (kGradientDelta - anti) / (sun - anti);
  const double cosine = (2.0 * weight - 1.0) / at.blend;
  if (!(std::abs(cosine) < 1.0)) return {};
  storage[0] = std::sqrt((1.0 - cosine) / (1.0 + cosine));
  return storage;
}

const sh::GaussRule& HemisphereQuadrature::ruleFor(const SunFrame& sun, double low, double high) const {
  if (sun.has_dark_rows || (sun.dark_side < 1.0 && low >= kFadeElevation)) return dark_;
  const LuminanceModel& m = sun.instant.sky().luminance;
  const double width = high - low;
  double scale = std::min(1.0, 3.0 * sun.hue_scale);  // The sky changes here over this distance.
  if (m.a != 0.0) scale = std::min(scale, std::max(low, width));
  if (m.c != 0.0) scale = std::min(scale, std::max({low - sun.elevation, sun.elevation - high, cuspScale(m) / 4.0}));
  return width > 0.3 * scale ? fine_ : width > 0.1 * scale ? middle_ : coarse_;
}

Latitude HemisphereQuadrature::latitude(const SunFrame& sun, double elevation, double weight) {
  const double half_sine = det::sin(0.5 * elevation);
  const double half_cosine = det::cos(0.5 * elevation);
  Latitude at;
  at.sine = 2.0 * half_sine * half_cosine;
  at.cosine = (half_cosine - half_sine) * (half_cosine + half_sine);
  at.weight = weight * at.cosine;
  at.gradation = det::gradation(sun.instant.sky().luminance, at.sine);
  at.sun_colour = sun.instant.sunColumn().at(elevation);
  at.anti_colour = sun.instant.antiColumn().at(elevation);
  at.blend = at.cosine / std::max(at.cosine, det::kAzimuthFade) * sun.length / std::max(sun.length, det::kAzimuthFade);
  at.dark_sun = std::sqrt(darkSide(at.sun_colour, at.anti_colour));
  at.dark_anti = std::sqrt(darkSide(at.anti_colour, at.sun_colour));
  at.has_dark = sun.has_dark_rows || at.dark_sun < 1.0 || at.dark_anti < 1.0;
  const double below = half_sine * sun.half_cosine - half_cosine * sun.half_sine;  // sin of half the difference
  const double above = half_sine * sun.half_cosine + half_cosine * sun.half_sine;
  at.near = below * below;
  at.far = above * above;
  at.reach = at.cosine * sun.length;
  return at;
}

Number3 shapeOn(const SunFrame& sun, const Latitude& at, const Azimuth& azimuth) {
  const SkyInstant& instant = sun.instant;
  const double to_sun = at.near + at.reach * azimuth.near;
  const double to_antipode = at.far + at.reach * azimuth.far;
  const LuminanceModel& m = instant.sky().luminance;
  const double exponential = sun.table != nullptr
                                 ? sun.table->exponential(to_sun, to_antipode)
                                 : det::exp(m.d * 2.0 * det::atan(std::sqrt(to_sun), std::sqrt(to_antipode)));
  const double luminance = at.gradation *
                           det::indicatrixFrom(m, exponential, instant.atRightAngle(), to_antipode - to_sun) /
                           instant.luminanceNorm();
  const Number3 colour = mix(at.anti_colour, at.sun_colour, 0.5 + 0.5 * at.blend * azimuth.cosine);
  return det::chromaticity(colour, kGradientDelta) * luminance;
}

}  // namespace welkin::model
