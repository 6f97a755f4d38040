// SPDX-License-Identifier: Apache-2.0
// The error of the sun's transfer by its bytes: 2 bands, and 1 to 16 modes, encoded, in a sector of a town. The
// reference is the same probes, traced with many paths at every knot and between knots.
//   sun_bench [PROBES [PATHS [KNOTS A DAY]]]
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

#include "probes/geometry/directions.h"
#include "probes/transfer/encoding_error.h"
#include "probes/transfer/relight.h"
#include "probes/transfer/trace_transfer.h"
#include "town.h"

namespace {

using namespace welkin;

constexpr double kPi = 3.14159265358979323846;

f64::Number3 sunAt(double time_h) {
  const double hour = 2.0 * kPi * (time_h - 6.0) / 24.0;
  const double tilt = 70.0 * kPi / 180.0;
  return geometry::unit(f64::Number3(std::cos(hour), std::sin(hour) * std::sin(tilt), std::sin(hour) * std::cos(tilt)));
}

struct Difference {
  double sum = 0.0;
  double worst = 0.0;
  std::size_t count = 0;
  void add(const f64::Number3& a, const f64::Number3& b) {
    for (int c = 0; c < 3; ++c, ++count) {
      const double difference = std::abs(a[c] - b[c]);
      sum += difference * difference;
      worst = std::max(worst, difference);
    }
  }
  double rms() const { return std::sqrt(sum / static_cast<double>(count)); }
};

}  // namespace

int main(int argc, char** argv) {
  const auto number = [&](int i, int otherwise) { return argc > i ? std::atoi(argv[i]) : otherwise; };
  constexpr int kTruthPaths = 32768;
  const int knots = number(3, 48);
  const geometry::Surfaces surfaces = bench::town();
  const geometry::Tracer tracer(surfaces);
  geometry::PlacedSector sector;
  for (const f64::Number3& position : bench::probesIn(tracer, number(1, 70))) sector.probe.push_back({position});
  const transfer::LightTrack track = transfer::trackOf(sunAt, knots);
  const transfer::LightTrack fine = transfer::trackOf(sunAt, 4 * knots);
  transfer::TransferSettings settings;
  settings.rays = static_cast<std::size_t>(number(2, 1024));
  settings.light_directions = track.direction;
  const auto traced = transfer::TransferTracer(tracer, settings).trace(sector);
  settings.rays = kTruthPaths;
  settings.light_directions = fine.direction;
  settings.light_rays = 16;
  sector.id = {0, 0};
  std::vector<transfer::TracedProbe> truth;
  for (std::size_t i = 0; i < sector.probe.size(); ++i)
    truth.push_back(transfer::TransferTracer(tracer, settings).trace(sector.probe[i].position, {9, 9}, i));

  std::vector<const transfer::ProbeTransfer*> probes;
  transfer::SectorProbes numbers;
  for (std::size_t i = 0; i < traced.size(); ++i) {
    probes.push_back(&traced[i].transfer);
    numbers.position.push_back(sector.probe[i].position);
    numbers.transfer.push_back(traced[i].transfer);
  }
  const transfer::SunModesFit all = transfer::fitSunModes(probes, track, {}, transfer::kMostSunModes);
  const auto errorOf = [&](const transfer::SectorProbes& p, transfer::SunTransfer way) {
    Difference error;
    for (std::size_t k = 0; k < fine.time_h.size(); ++k) {
      const transfer::Relight light =
          transfer::relightAt(fine.time_h[k], {}, {fine.direction[k], f64::Number3(1.0)}, {}, way, p.modes);
      for (std::size_t i = 0; i < p.transfer.size(); ++i) {
        const auto bounce = transfer::relit(p.transfer[i], p.sun[i], light).sun_bounce;
        for (std::size_t b = 0; b < transfer::kDirections; ++b) error.add(bounce[b], truth[i].transfer.sun[b][k]);
      }
    }
    return error;
  };
  Difference signal;
  for (const transfer::TracedProbe& t : truth)
    for (const auto& direction : t.transfer.sun)
      for (const f64::Number3& s : direction) signal.add(s, f64::Number3(0.0));
  fmt::print("{} probes, {} paths, {} knots of the sun; irradiance of a light of normal irradiance 1\n", traced.size(),
             number(2, 1024), track.time_h.size());
  fmt::print("rms {:.4f}, largest {:.4f}\n", signal.rms(), signal.worst);
  fmt::print("sun          bytes a probe   sector      rms   worst   of these by encoding\n");
  for (std::size_t m = 0; m <= all.modes.count(); ++m) {
    const transfer::SunModesFit fit = transfer::firstModes(all, m);
    numbers.modes = fit.modes;
    numbers.sun = fit.coefficient;
    const transfer::EncodedProbes encoded = transfer::encodeProbes(numbers);
    const transfer::SectorProbes decoded = transfer::decodedProbes(encoded, {0, 0});
    const Difference error = errorOf(decoded, m == 0 ? transfer::SunTransfer::sh : transfer::SunTransfer::directional);
    fmt::print("{:<12} {:>13} {:>8} {:>8.4f} {:>7.4f}   {:.4f} worst\n", m == 0 ? "sh" : fmt::format("{} modes", m),
               encoded.bytesAProbe(), encoded.bytes().total() + 4096, error.rms(), error.worst,
               transfer::encodingError(numbers, decoded).sun);
  }
  return EXIT_SUCCESS;
}
