// SPDX-License-Identifier: Apache-2.0
// The quadrature of projection.h: the positions of its panels and the sky at its nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "sh/quadrature.h"
#include "sky/model/indicatrix_table.h"
#include "sky/model/sky.h"

namespace welkin::model {

using det::Number3;

/// A circle of constant elevation in the sun's frame, with the quantities that are constant along it.
struct Latitude {
  double sine = 0.0;  ///< of the elevation
  double cosine = 1.0;
  double weight = 0.0;  ///< weight in the elevation integral, with the cosine of the solid angle
  double gradation = 1.0;
  Number3 sun_colour;  ///< colour of the sun's gradient
  Number3 anti_colour;
  double blend = 0.0;  ///< amplitude of the azimuth blend: the sun's weight is 1/2 + blend cos(alpha) / 2
  // tan of half the azimuth, counted from the darker gradient's side, at which the other gradient takes over the hue. 1
  // if both are equally bright.
  double dark_sun = 1.0;
  double dark_anti = 1.0;
  bool has_dark = false;  ///< whether a gradient is dark, here or in a neighbouring row
  // sin^2 of half the angle to the sun is near + reach sin^2(alpha / 2). For the antipode it is far + reach cos^2(alpha
  // / 2).
  double near = 0.0;
  double far = 0.0;
  double reach = 0.0;
};

/// A point of a circle at azimuth alpha in (0, pi) from the sun's.
struct Azimuth {
  double cosine = 1.0;  ///< of alpha
  double sine = 0.0;
  double near = 0.0;  ///< sin^2(alpha / 2)
  double far = 1.0;   ///< cos^2(alpha / 2)
  double weight = 0.0;
};

/// The quantities that stay constant while an instant is integrated.
struct SunFrame {
  /// `table` belongs to the instant's model. Null selects the exact exponential.
  SunFrame(const SkyInstant& instant, const IndicatrixTable* table);

  const SkyInstant& instant;
  const IndicatrixTable* table;
  double elevation;
  double half_sine;  ///< of half the elevation
  double half_cosine;
  double length;       ///< horizontal length of the sun's direction
  bool has_dark_rows;  ///< a gradient has a row much darker than its neighbour, or so dark that colours fade
  double hue_scale;    ///< range of elevations over which a gradient's hue changes, radians
  double dark_side;    ///< ratio of the darker gradient to the brighter where their blend starts to fade, or 1
};

class HemisphereQuadrature {
 public:
  /// `orders` is the number of cosines of multiples of the azimuth that the caller integrates against. `d` comes from
  /// the luminance model; a steeper cusp takes narrower panels.
  HemisphereQuadrature(double tolerance, int orders, double d);

  /// Elevations in [0, pi/2], ascending, between which the sky is smooth. `extra` adds the caller's own.
  std::vector<double> panels(const SunFrame& sun, std::span<const double> extra) const;

  /// Calls visit(latitude) for every node of the panels.
  template <typename Visit>
  void forEachLatitude(const SunFrame& sun, std::span<const double> extra, Visit&& visit) const {
    const std::vector<double> edge = panels(sun, extra);
    for (std::size_t i = 1; i < edge.size(); ++i)
      sh::forEachNode(ruleFor(sun, edge[i - 1], edge[i]), edge[i - 1], edge[i],
                      [&](double elevation, double weight) { visit(latitude(sun, elevation, weight)); });
  }

  /// Calls visit(azimuth) for azimuths on one side, from the sun's to the opposite. `extra` holds up to 4 values of
  /// tan(alpha / 2) at which the caller's integrand bends.
  template <typename Visit>
  void forEachAzimuth(const Latitude& at, std::span<const double> extra, Visit&& visit) const {
    forEachAzimuthInHalf(at, at.near, at.dark_sun, extra, [&](double t, double weight) {
      const double norm = 1.0 / (1.0 + t * t);
      visit(Azimuth{(1.0 - t * t) * norm, 2.0 * t * norm, t * t * norm, norm, 2.0 * norm * weight});
    });
    double mirrored[4];
    const std::size_t count = std::min<std::size_t>(extra.size(), 4);
    for (std::size_t i = 0; i < count; ++i) mirrored[i] = 1.0 / extra[i];
    forEachAzimuthInHalf(at, at.far, at.dark_anti, {mirrored, count}, [&](double t, double weight) {
      const double norm = 1.0 / (1.0 + t * t);
      visit(Azimuth{(t * t - 1.0) * norm, 2.0 * t * norm, norm, t * t * norm, 2.0 * norm * weight});
    });
  }

  /// Adds to order[m] the integral of the sky's radiance times cos(m alpha) over half the circle. Returns the number of
  /// directions evaluated.
  std::size_t addOrders(const SunFrame& sun, const Latitude& at, std::span<Number3> order) const;

  /// Whether a gradient is dark enough here for its colours to fade.
  static bool fades(const SkyInstant& instant);
  /// Returns tan(alpha / 2) where the blended colour crosses the luminance below which colours fade. Empty if there is
  /// no crossing.
  static std::span<const double> fadeCrossing(const Latitude& at, double (&storage)[1]);

 private:
  const sh::GaussRule& ruleFor(const SunFrame& sun, double low, double high) const;
  static Latitude latitude(const SunFrame& sun, double elevation, double weight);
  /// Panels that shrink towards a row much darker than its neighbour, where the hue changes as 1 / luminance.
  static void addDarkRows(const GradientColumn& column, std::vector<double>& edge);
  static void addFadeCrossings(const SunFrame& sun, std::vector<double>& edge);

  /// Panels of t = tan(alpha / 2) over [0, 1], with alpha counted from the cusp's side. The distance to the cusp is
  /// near + (near + reach) t^2 over 1 + t^2, with its root at t = i h. A dark gradient's hue has a pole at i dark.
  /// Panels start at kFirst times the smaller of the two and grow by kGrowth.
  template <typename Visit>
  void forEachAzimuthInHalf(const Latitude& at, double distance, double dark, std::span<const double> extra,
                            Visit&& visit) const {
    const double h = std::max(std::min(std::sqrt(distance / (distance + at.reach)), dark), smallest_h_);
    const double growth = dark < 1.0 ? kDarkGrowth : kGrowth;
    double edge[32];
    int edges = 0;
    edge[edges++] = 0.0;
    for (double t = kFirst * h; t < 0.5 * (1.0 + 1.0 / growth); t *= growth) edge[edges++] = t;
    edge[edges++] = 1.0;
    for (const double t : extra.first(std::min<std::size_t>(extra.size(), 4))) {
      if (!(t > 0.0 && t < 1.0)) continue;
      int place = edges++;
      for (; edge[place - 1] > t; --place) edge[place] = edge[place - 1];
      edge[place] = t;
    }
    const sh::GaussRule& rule = at.has_dark ? dark_azimuth_ : azimuth_;
    for (int i = 1; i < edges; ++i) sh::forEachNode(rule, edge[i - 1], edge[i], visit);
  }

  static constexpr double kFirst = 1.25;      ///< the first panel's end, in units of h
  static constexpr double kGrowth = 5.0;      ///< growth of the panels after it
  static constexpr double kDarkGrowth = 2.5;  ///< growth beside a pole, which is stronger than a cusp
  double smallest_h_;
  sh::GaussRule coarse_, middle_, fine_, azimuth_;
  sh::GaussRule dark_, dark_azimuth_;  ///< where a dark gradient's hue has poles
};

/// The sky's radiance at intensity 1 at a point of a circle of constant elevation.
Number3 shapeOn(const SunFrame& sun, const Latitude& at, const Azimuth& azimuth);

}  // namespace welkin::model
