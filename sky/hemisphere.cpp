// SPDX-License-Identifier: Apache-2.0
#include "sky/hemisphere.h"

namespace welkin::sky {
namespace {

constexpr double kRatio = 3.0;  // of neighbouring panels that shrink towards a cusp or a layer

/// sin 10 degrees is the cosine of the elevation at which the blend over azimuth starts to fade.
const double kFadeElevation = 80.0 / 180.0 * det::kPi;

double cuspScale(const LuminanceModel& m) {
  return 1.0 / std::max(1.0, -m.d);
}

}  // namespace

HemisphereQuadrature::HemisphereQuadrature(int refinement)
    : smallest_h_(1e-3 / refinement),
      coarse_(sh::gaussLegendre(3 * refinement)),
      middle_(sh::gaussLegendre(5 * refinement)),
      fine_(sh::gaussLegendre(8 * refinement)),
      azimuth_(sh::gaussLegendre(8 * refinement)) {}

std::vector<double> HemisphereQuadrature::panels(const SkyInstant& instant, std::span<const double> extra) const {
  const LuminanceModel& m = instant.sky().luminance;
  const double sun = det::elevationOf(instant.sunDirection());
  std::vector<double> edge(extra.begin(), extra.end());
  edge.push_back(kFadeElevation);
  if (m.a != 0.0) {
    const double layer = std::max(-m.b / 40.0, 1e-7);  // exp(-40) of the layer is left below it
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

  const auto tidy = [&] {
    std::erase_if(edge, [](double e) { return !(e > 1e-12 && e < det::kHalfPi - 1e-12); });
    edge.push_back(0.0);
    edge.push_back(det::kHalfPi);
    std::sort(edge.begin(), edge.end());
    edge.erase(std::unique(edge.begin(), edge.end(), [](double a, double b) { return b - a < 1e-12; }), edge.end());
  };
  tidy();
  addFadeCrossings(instant, edge);
  tidy();
  return edge;
}

bool HemisphereQuadrature::fades(const SkyInstant& instant) {
  const auto dark = [](const GradientColumn& column) {
    return std::any_of(column.row.begin(), column.row.end(),
                       [](const Number3& c) { return det::luminanceOf(c) < kGradientDelta; });
  };
  return dark(instant.sunColumn()) || dark(instant.antiColumn());
}

void HemisphereQuadrature::addFadeCrossings(const SkyInstant& instant, std::vector<double>& edge) {
  // Luminance of the blended colour at the sun's azimuth and at the opposite, above what makes colours fade.
  const auto excess = [&](double elevation, double cos_alpha) {
    const Latitude at = latitude(instant, elevation, 1.0);
    const double w = 0.5 + 0.5 * at.blend * cos_alpha;
    return det::luminanceOf(mix(at.anti_colour, at.sun_colour, w)) - kGradientDelta;
  };
  if (!fades(instant)) return;
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
      edge.push_back(0.5 * (low + high));
    }
}

std::span<const double> HemisphereQuadrature::fadeCrossing(const Latitude& at, double (&storage)[1]) {
  const double sun = det::luminanceOf(at.sun_colour);
  const double anti = det::luminanceOf(at.anti_colour);
  if ((sun < kGradientDelta) == (anti < kGradientDelta) || !(at.blend > 0.0)) return {};
  const double weight = (kGradientDelta - anti) / (sun - anti);
  const double cosine = (2.0 * weight - 1.0) / at.blend;
  if (!(std::abs(cosine) < 1.0)) return {};
  storage[0] = det::atan(std::sqrt(1.0 - cosine * cosine), cosine);
  return storage;
}

const sh::GaussRule& HemisphereQuadrature::ruleFor(const SkyInstant& instant, double low, double high) const {
  const LuminanceModel& m = instant.sky().luminance;
  const double sun = det::elevationOf(instant.sunDirection());
  const double width = high - low;
  double scale = 1.0;  // over which the sky changes here
  if (m.a != 0.0) scale = std::min(scale, std::max(low, width));
  if (m.c != 0.0) scale = std::min(scale, std::max({low - sun, sun - high, cuspScale(m) / 4.0}));
  return width > 0.3 * scale ? fine_ : width > 0.1 * scale ? middle_ : coarse_;
}

Latitude HemisphereQuadrature::latitude(const SkyInstant& instant, double elevation, double weight) {
  const Number3& sun = instant.sunDirection();
  const double sun_length = det::horizontalLength(sun);
  const double sun_elevation = det::elevationOf(sun);
  Latitude at;
  at.sine = det::sin(elevation);
  at.cosine = det::cos(elevation);
  at.weight = weight * at.cosine;
  at.gradation = det::gradation(instant.sky().luminance, at.sine);
  at.sun_colour = instant.sunColumn().at(elevation);
  at.anti_colour = instant.antiColumn().at(elevation);
  at.blend = at.cosine / std::max(at.cosine, det::kAzimuthFade) * sun_length / std::max(sun_length, det::kAzimuthFade);
  const double below = det::sin(0.5 * (elevation - sun_elevation));
  const double above = det::sin(0.5 * (elevation + sun_elevation));
  at.near = below * below;
  at.far = above * above;
  at.reach = at.cosine * sun_length;
  return at;
}

Number3 shapeOn(const SkyInstant& instant, const Latitude& at, double cos_alpha) {
  const double to_sun = at.near + at.reach * 0.5 * (1.0 - cos_alpha);
  const double to_antipode = at.far + at.reach * 0.5 * (1.0 + cos_alpha);
  const double angle = 2.0 * det::atan(std::sqrt(to_sun), std::sqrt(to_antipode));
  const double luminance = at.gradation * det::indicatrix(instant.sky().luminance, angle) / instant.luminanceNorm();
  const Number3 colour = mix(at.anti_colour, at.sun_colour, 0.5 + 0.5 * at.blend * cos_alpha);
  return det::chromaticity(colour, kGradientDelta) * luminance;
}

}  // namespace welkin::sky
