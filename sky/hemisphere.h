// SPDX-License-Identifier: Apache-2.0
// The quadrature of projection.h: where its panels lie and what the sky is at its nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "sh/quadrature.h"
#include "sky/sky.h"

namespace welkin::sky {

/// A circle of constant elevation in the sun's frame, and what is constant along it.
struct Latitude {
  double sine = 0.0;  ///< of the elevation
  double cosine = 1.0;
  double weight = 0.0;  ///< of the elevation integral, the cosine of the solid angle included
  double gradation = 1.0;
  Number3 sun_colour;  ///< of the two gradients
  Number3 anti_colour;
  double blend = 0.0;  ///< amplitude of the azimuth blend: the sun's weight is 1/2 + blend cos(alpha) / 2
  // sin^2 of half the angle to the sun is near + reach sin^2(alpha / 2), to its antipode far + reach cos^2(alpha / 2).
  double near = 0.0;
  double far = 0.0;
  double reach = 0.0;
};

class HemisphereQuadrature {
 public:
  explicit HemisphereQuadrature(int refinement);

  /// Elevations in [0, pi/2] between which the sky is smooth, ascending; `extra` adds the caller's own.
  std::vector<double> panels(const SkyInstant& instant, std::span<const double> extra) const;

  /// Calls visit(latitude) for every node of the panels.
  template <typename Visit>
  void forEachLatitude(const SkyInstant& instant, std::span<const double> extra, Visit&& visit) const {
    const std::vector<double> edge = panels(instant, extra);
    for (std::size_t i = 1; i < edge.size(); ++i)
      sh::forEachNode(ruleFor(instant, edge[i - 1], edge[i]), edge[i - 1], edge[i],
                      [&](double elevation, double weight) { visit(latitude(instant, elevation, weight)); });
  }

  /// Calls visit(alpha, weight) for the azimuths from the sun's (0) to the opposite (pi) on one side. `extra` holds up
  /// to 4 azimuths in (0, pi) at which the caller's integrand bends.
  template <typename Visit>
  void forEachAzimuth(const Latitude& at, std::span<const double> extra, Visit&& visit) const {
    forEachAzimuthInHalf(at.near, at.reach, extra, visit);
    double mirrored[4];
    const std::size_t count = std::min<std::size_t>(extra.size(), 4);
    for (std::size_t i = 0; i < count; ++i) mirrored[i] = det::kPi - extra[i];
    forEachAzimuthInHalf(at.far, at.reach, {mirrored, count},
                         [&](double beta, double weight) { visit(det::kPi - beta, weight); });
  }

  /// Whether a gradient is dark enough here for its colours to fade, which takes twice the nodes: within the texel
  /// beside a black one the hue changes as 1 / luminance.
  static bool fades(const SkyInstant& instant);
  /// Azimuth at which the blended colour crosses the luminance under which colours fade; none gives an empty span.
  static std::span<const double> fadeCrossing(const Latitude& at, double (&storage)[1]);

 private:
  const sh::GaussRule& ruleFor(const SkyInstant& instant, double low, double high) const;
  static Latitude latitude(const SkyInstant& instant, double elevation, double weight);
  static void addFadeCrossings(const SkyInstant& instant, std::vector<double>& edge);

  template <typename Visit>
  void forEachAzimuthInHalf(double distance, double reach, std::span<const double> extra, Visit&& visit) const {
    // alpha = h sinh u on [0, pi/2], h the distance to the cusp in units of alpha.
    constexpr double kSmooth = 4.0;  // from there on the map is a line to the quadrature's accuracy
    const double h =
        reach * kSmooth * kSmooth > 4.0 * distance ? std::max(2.0 * std::sqrt(distance / reach), smallest_h_) : kSmooth;
    const auto inverse = [h](double alpha) { return det::log(alpha / h + std::sqrt(alpha * alpha / (h * h) + 1.0)); };
    double edge[6] = {0.0, inverse(det::kHalfPi)};
    int edges = 2;
    for (const double alpha : extra.first(std::min<std::size_t>(extra.size(), 4))) {
      if (!(alpha > 0.0 && alpha < det::kHalfPi)) continue;
      int place = edges++;
      for (const double u = inverse(alpha); edge[place] = u, edge[place - 1] > u; --place)
        edge[place] = edge[place - 1];
    }
    for (int i = 1; i < edges; ++i) {
      const double length = edge[i] - edge[i - 1];
      const int count = std::max(1, static_cast<int>(std::ceil(length / kLongestPanel)));
      for (int k = 0; k < count; ++k)
        sh::forEachNode(azimuth_, edge[i - 1] + length * k / count, edge[i - 1] + length * (k + 1) / count,
                        [&](double u, double weight) {
                          const double grown = det::exp(u);
                          const double shrunk = 1.0 / grown;
                          visit(0.5 * h * (grown - shrunk), weight * 0.5 * h * (grown + shrunk));
                        });
    }
  }

  static constexpr double kLongestPanel = 1.7;  ///< in u
  double smallest_h_;
  sh::GaussRule coarse_, middle_, fine_, azimuth_;
};

/// The sky's radiance at intensity 1 on a circle of constant elevation, `cos_alpha` from the sun's azimuth.
Number3 shapeOn(const SkyInstant& instant, const Latitude& at, double cos_alpha);

}  // namespace welkin::sky
