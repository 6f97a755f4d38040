// SPDX-License-Identifier: Apache-2.0
#include "reference.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <mutex>

#include "sh/quadrature.h"

namespace welkin::tests {
namespace {

void accumulate(Reference& sum, const Number3& d, const Number3& normal, const Number3& radiance) {
  const auto basis = f64::shBasis(d);
  for (std::size_t i = 0; i < sum.radiance_sh.size(); ++i) sum.radiance_sh[i] += radiance * basis.v[i];
  sum.horizontal_irradiance += radiance * std::max(dot(d, normal), 0.0);
}

}  // namespace

Reference referenceAboutSun(const model::SkyInstant& instant, int bands) {
  const Number3 sun = instant.sunDirection();
  Number3 highest = Number3(0.0, 1.0, 0.0) - sun * sun.y;  // where the circle about the sun is highest
  const double tilt = std::sqrt(dot(highest, highest));
  highest = tilt > 1e-9 ? highest / tilt : Number3(1.0, 0.0, 0.0);
  const Number3 side = cross(sun, highest);
  const double elevation = std::asin(sun.y);
  const sh::GaussRule rule = sh::gaussLegendre(8);
  Reference sum{std::vector<Number3>(static_cast<std::size_t>(bands * bands)), Number3(0.0)};

  const auto circle = [&](double theta, double weight) {
    const double middle = sun.y * std::cos(theta);
    const double reach = tilt > 1e-9 ? std::cos(elevation) * std::sin(theta) : 0.0;
    const double clip = middle - reach >= 0.0 ? M_PI : middle + reach <= 0.0 ? 0.0 : std::acos(-middle / reach);
    std::vector<double> edge = {0.0};
    for (int k = 14; k >= 0; --k) edge.push_back(clip - clip * 0.999 * std::pow(0.5, 14 - k));
    edge.push_back(clip);
    for (std::size_t i = 1; i < edge.size() && clip > 0.0; ++i)
      sh::forEachNode(rule, edge[i - 1], edge[i], [&](double psi, double w) {
        for (const double sign : {-1.0, 1.0}) {
          Number3 d =
              sun * std::cos(theta) + (highest * std::cos(psi) + side * (sign * std::sin(psi))) * std::sin(theta);
          d.y = std::max(d.y, 0.0);
          accumulate(sum, d, {0.0, 1.0, 0.0}, instant.shape(d) * (w * weight * std::sin(theta)));
        }
      });
  };
  std::vector<double> edge = {0.0, M_PI};
  for (int i = 1; i < 24; ++i) edge.push_back(M_PI * i / 24);
  for (const double bend : {elevation, -elevation, M_PI - elevation, M_PI + elevation}) {
    if (!(bend > 0.0 && bend < M_PI)) continue;
    edge.push_back(bend);
    for (double r = 0.5; r > 1e-5; r /= 2.0)
      for (const double e : {bend - r, bend + r})
        if (e > 0.0 && e < M_PI) edge.push_back(e);
  }
  std::sort(edge.begin(), edge.end());
  for (std::size_t i = 1; i < edge.size(); ++i)
    if (edge[i] - edge[i - 1] > 1e-12) sh::forEachNode(rule, edge[i - 1], edge[i], circle);
  return sum;
}

Reference referenceOverWorld(const model::SkyInstant& instant, int bands, int n, const Number3& normal) {
  const auto count = static_cast<std::size_t>(bands * bands);
  std::vector<Reference> row(static_cast<std::size_t>(n), {std::vector<Number3>(count), Number3(0.0)});
  tbb::parallel_for(0, n, [&](int i) {
    const double e = (i + 0.5) / n * M_PI / 2;
    for (int j = 0; j < 4 * n; ++j) {
      const double a = (j + 0.5) / (4 * n) * 2 * M_PI;
      const Number3 d(std::cos(e) * std::sin(a), std::sin(e), -std::cos(e) * std::cos(a));
      const double area = std::cos(e) * M_PI / 2 / n * 2 * M_PI / (4 * n);
      accumulate(row[static_cast<std::size_t>(i)], d, normal, instant.shape(d) * area);
    }
  });
  Reference sum{std::vector<Number3>(count), Number3(0.0)};
  for (const Reference& r : row) {
    for (std::size_t k = 0; k < count; ++k) sum.radiance_sh[k] += r.radiance_sh[k];
    sum.horizontal_irradiance += r.horizontal_irradiance;
  }
  return sum;
}

}  // namespace welkin::tests
