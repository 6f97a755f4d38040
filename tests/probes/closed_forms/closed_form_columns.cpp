// SPDX-License-Identifier: Apache-2.0
#include "closed_form_columns.h"

#include <algorithm>
#include <cmath>

#include "probes/sectors/level_light.h"
#include "probes/transfer/local_relight.h"
#include "probes/transfer/trace_transfer.h"

namespace welkin::tests {
namespace {

constexpr double kTime_h = 12.0;
constexpr std::size_t kProbes = 64;

using FourDirections = std::array<Number3, transfer::kDirections>;

/// Irradiance over pi of one independent probe: traced, its sun fitted by modes, relit.
FourDirections probeOf(const ClosedForm& form, const transfer::TransferTracer& transfer,
                       const transfer::LocalTransferTracer& local, std::size_t index) {
  const transfer::TracedProbe traced = transfer.trace(form.position, {3, -2}, index);
  const transfer::ProbeTransfer* const one[] = {&traced.transfer};
  const auto& lights = transfer.settings().light_directions;
  const transfer::LightTrack track{std::vector<double>(lights.size(), kTime_h), lights};
  const transfer::SunModesFit fit = transfer::fitSunModes(one, track, {}, transfer::kMostSunModes);
  transfer::LightAt sun;
  if (!lights.empty()) sun = {lights[0], form.sky.sun.normalIrradianceAt(kTime_h)};
  const transfer::Relight light = transfer::relightAt(kTime_h, sectors::skyShAt(form.sky, kTime_h), sun, {}, form.sun,
                                                      fit.modes, {}, form.sky_bounce);
  FourDirections irradiance = transfer::relit(traced.transfer, fit.coefficient[0], light).total();
  if (!form.lamp.empty() && form.bounces > 0) {
    const FourDirections of_lamp =
        transfer::relitLocal(local.trace(form.position, {3, -2}, index).transfer, std::vector{form.lamp[0].intensity});
    for (std::size_t b = 0; b < transfer::kDirections; ++b) irradiance[b] += of_lamp[b];
  }
  for (Number3& e : irradiance) e = e / det::kPi;
  return irradiance;
}

Number3 shaded(const FourDirections& irradiance, const Number3& normal) {
  const auto weight = transfer::shadingWeights(normal);
  Number3 sum(0.0);
  for (std::size_t b = 0; b < transfer::kDirections; ++b) sum += irradiance[b] * weight[b];
  return sum;
}

/// Mean over the probes of a quantity, and its standard error.
template <typename Of>
reference::Estimate meanOf(const std::vector<FourDirections>& probes, const Of& of) {
  const auto count = static_cast<double>(probes.size());
  reference::Estimate mean;
  for (const FourDirections& probe : probes) mean.value += of(probe) / count;
  Number3 squares(0.0);
  for (const FourDirections& probe : probes) {
    const Number3 off = of(probe) - mean.value;
    squares += off * off;
  }
  for (int c = 0; c < 3; ++c) mean.standard_error[c] = std::sqrt(squares[c] / (count * (count - 1.0)));
  return mean;
}

Compared compared(const reference::Estimate& estimate, const Number3& exact, const Number3& expected) {
  return {estimate.value, estimate.standard_error, expected, expected - exact};
}

}  // namespace

ClosedFormColumns columnsOf(const ClosedForm& form, std::size_t paths) {
  const geometry::Tracer tracer(form.surfaces);
  const reference::DistantLight distant(form.sky, kTime_h);
  const auto basis = transfer::transferBasis();
  ClosedFormColumns columns;
  std::vector<Number3> normals;
  for (const AskedNormal& asked : form.asked) normals.push_back(asked.normal);
  normals.insert(normals.end(), basis.begin(), basis.end());
  for (const Number3& normal : normals) {
    reference::Estimate e =
        reference::traceReference(tracer, distant, form.lamp, form.position, normal, {paths, form.bounces, 1}).total;
    e.value = e.value / det::kPi;
    e.standard_error = e.standard_error / det::kPi;
    columns.path_tracer.push_back(compared(e, form.exact(normal), form.exact(normal)));
  }

  transfer::TransferSettings settings;
  settings.rays = paths / kProbes;
  settings.bounces = form.bounces;
  settings.ground_albedo = form.sky.ground_albedo;
  settings.light_directions = {form.sky.sun.path.directionAt(kTime_h)};
  const transfer::TransferTracer transfer(tracer, settings);
  transfer::LocalSettings local_settings;
  local_settings.rays = settings.rays;
  local_settings.bounces = std::max(form.bounces, 1);
  std::vector<Number3> lamps;
  for (const reference::LocalLight& lamp : form.lamp) lamps.push_back(lamp.position);
  const transfer::LocalTransferTracer local(tracer, local_settings, lamps);
  std::vector<FourDirections> probes;
  for (std::size_t i = 0; i < kProbes; ++i) probes.push_back(probeOf(form, transfer, local, i));

  FourDirections held;
  for (std::size_t b = 0; b < transfer::kDirections; ++b) {
    held[b] = form.held ? form.held(basis[b]) : form.exact(basis[b]);
    columns.transfer[b] =
        compared(meanOf(probes, [&](const FourDirections& p) { return p[b]; }), form.exact(basis[b]), held[b]);
  }
  for (const AskedNormal& asked : form.asked)
    columns.four_directions.push_back(
        compared(meanOf(probes, [&](const FourDirections& p) { return shaded(p, asked.normal); }),
                 form.exact(asked.normal), shaded(held, asked.normal)));
  return columns;
}

bool agrees(const ClosedForm& form, const Compared& compared) {
  constexpr double kStandardErrors = 3.0;
  constexpr double kRounding = 1e-6;
  Number3 largest(0.0);
  for (const Number3& direction : transfer::transferBasis())
    for (int c = 0; c < 3; ++c) largest[c] = std::max(largest[c], form.exact(direction)[c]);
  for (int c = 0; c < 3; ++c) {
    const double bound = kStandardErrors * compared.standard_error[c] + (form.level_bound + kRounding) * largest[c];
    if (!(std::abs(compared.found[c] - compared.expected[c]) <= bound)) return false;
  }
  return true;
}

}  // namespace welkin::tests
