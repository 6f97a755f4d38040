// SPDX-License-Identifier: Apache-2.0
// The error of fewer bits and scales in the sky's transfer, beside the noise of the rays. It compares the irradiance of
// a level's probes, by direction and channel, under a uniform sky and its own at 24 hours, in percent of the open
// sky's.
//   encoding_bench LEVEL.toml [PROBES]
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "probes/build/subject.h"
#include "probes/placement/placement.h"
#include "probes/sectors/level_light.h"
#include "probes/transfer/fixed_point.h"
#include "probes/transfer/trace_transfer.h"
#include "rounding.h"
#include "sky/base/error.h"

namespace welkin::tests {

using f64::Number3;
namespace {

constexpr std::size_t kTruthPaths = 65536;

using Transfers = std::vector<transfer::ProbeTransfer>;

/// Groups of a probe's numbers that share a scale.
struct Sharing {
  const char* name;
  std::size_t scales;
  std::size_t (*group)(std::size_t direction, std::size_t coefficient);
};
constexpr Sharing kSharing[] = {
    {"a probe", 1, [](std::size_t, std::size_t) { return std::size_t{0}; }},
    {"a band", 2, [](std::size_t, std::size_t k) { return std::size_t{k > 0}; }},
    {"a direction", 4, [](std::size_t b, std::size_t) { return b; }},
    {"a direction and band", 8, [](std::size_t b, std::size_t k) { return 2 * b + (k > 0); }},
};

/// Whether numbers that are never negative have a sign bit, too (of_all).
enum class Sign { of_all, of_some };

transfer::ProbeTransfer roundedSky(transfer::ProbeTransfer t, int bits, const Sharing& sharing, Sign sign) {
  std::array<double, 8> largest{};
  const auto eachNumber = [&](auto&& what) {
    for (std::size_t b = 0; b < transfer::kDirections; ++b)
      for (std::size_t k = 0; k < 4; ++k)
        for (int c = 0; c < 3; ++c) what(t.sky[b][k][c], largest[sharing.group(b, k)], k);
  };
  eachNumber([](double x, double& l, std::size_t) { l = std::max(l, std::abs(x)); });
  eachNumber([&](double& x, double l, std::size_t k) {
    x = bench::rounded(x, transfer::scaleOf(transfer::scaleFor(l)), bits, sign == Sign::of_all || k > 1);
  });
  return t;
}

transfer::ProbeTransfer roundedVisibility(transfer::ProbeTransfer t, int bits) {
  for (double& v : t.visibility) v = bench::rounded(v, 1.0, bits, false);
  return t;
}

/// The sky at one time.
struct Instant {
  transfer::Relight light;
  double open;  ///< horizontal irradiance, luminance
};

Instant instantOf(const std::array<Number3, 4>& sh) {
  const Number3 open = sh[0] * (det::cosineLobe(0) * det::kShConstant) + sh[1] * (det::cosineLobe(1) * det::kShLinear);
  return {transfer::relightAt(12.0, sh, {}, {}, transfer::SunTransfer::none, {}), det::luminanceOf(open)};
}

std::vector<Instant> instantsOf(const model::Sky& sky) {
  std::vector<Instant> instants = {instantOf({Number3(std::sqrt(det::kPi)), Number3(std::sqrt(3.0 * det::kPi) / 2.0)})};
  for (int hour = 0; hour < 24; ++hour) instants.push_back(instantOf(sectors::skyShAt(sky, hour)));
  return instants;
}

/// Text of the root mean square and the largest difference, percent.
std::string difference(const Transfers& a, const Transfers& b, const std::vector<Instant>& instants) {
  double squares = 0.0;
  double worst = 0.0;
  std::size_t count = 0;
  for (const Instant& instant : instants)
    for (std::size_t i = 0; i < a.size(); ++i) {
      const auto x = transfer::relit(a[i], {}, instant.light).sky;
      const auto y = transfer::relit(b[i], {}, instant.light).sky;
      for (std::size_t d = 0; d < transfer::kDirections; ++d)
        for (int c = 0; c < 3; ++c, ++count) {
          const double e = 100.0 * std::abs(x[d][c] - y[d][c]) / instant.open;
          squares += e * e;
          worst = std::max(worst, e);
        }
    }
  return fmt::format("{:8.4f} {:8.3f}", std::sqrt(squares / static_cast<double>(count)), worst);
}

/// Some probes of a level, spread over its sectors.
class LevelProbes {
 public:
  LevelProbes(const geometry::Surfaces& surfaces, const build::BakeSection& section, const Number3& ground_albedo,
              std::size_t most)
      : tracer_(surfaces), section_(section), ground_albedo_(ground_albedo) {
    placement::PlacementReport report;
    for (const geometry::SectorId id : placement::sectorsOf(surfaces, section.probes)) {
      const geometry::PlacedSector placed = placement::placeSector(tracer_, id, section.probes, report);
      for (std::size_t i = 0; i < placed.probe.size(); ++i) place_.push_back({placed.probe[i].position, id, i});
    }
    all_ = place_.size();
    const std::size_t stride = std::max<std::size_t>(1, (all_ + most - 1) / most);
    for (std::size_t i = 0; i * stride < all_; ++i) place_[i] = place_[i * stride];
    place_.resize((all_ + stride - 1) / stride);
  }

  std::size_t count() const { return place_.size(); }
  std::size_t all() const { return all_; }

  /// Transfers by this many rays. `error` becomes half the 95 % confidence interval of the worst probe.
  Transfers traced(std::size_t rays, double& error) const {
    transfer::TransferSettings settings;
    settings.rays = rays;
    settings.bounces = section_.transfer.bounces;
    settings.ground_albedo = ground_albedo_;
    const transfer::TransferTracer transfer(tracer_, settings);
    std::vector<transfer::TracedProbe> probe(count());
    tbb::parallel_for(std::size_t{0}, count(), [&](std::size_t i) {
      probe[i] = transfer.trace(place_[i].position, place_[i].sector, place_[i].index);
    });
    Transfers transfers;
    error = 0.0;
    for (transfer::TracedProbe& p : probe) {
      transfers.push_back(std::move(p.transfer));
      error = std::max(error, p.effort.error);
    }
    return transfers;
  }

 private:
  struct Place {
    Number3 position;
    geometry::SectorId sector;
    std::size_t index;
  };
  geometry::Tracer tracer_;
  build::BakeSection section_;
  Number3 ground_albedo_;
  std::vector<Place> place_;
  std::size_t all_ = 0;
};

void run(const std::filesystem::path& file, std::size_t most) {
  const build::Subject subject = build::readLevel(file);
  const model::Sky& sky = subject.sky.sky;
  const LevelProbes probes(subject.level->surfaces, subject.level->section, sky.ground_albedo, most);
  const std::vector<Instant> instants = instantsOf(sky);
  double error = 0.0;
  const Transfers truth = probes.traced(kTruthPaths, error);
  fmt::print("{} of {} probes: rms and worst in % of the open sky's horizontal irradiance\n", probes.count(),
             probes.all());
  for (const std::size_t rays : {64, 256, 1024, 4096, 16384}) {
    const std::string text = difference(probes.traced(rays, error), truth, instants);
    fmt::print("{:>5} rays, not {:<39} {}   95 % within {:.2f}\n", rays, kTruthPaths, text, 100.0 * error);
  }
  const auto row = [&](const std::string& name, double bytes, auto&& encoded) {
    Transfers other;
    for (const transfer::ProbeTransfer& t : truth) other.push_back(encoded(t));
    fmt::print("{:<47} {:4.1f} bytes {}\n", name, bytes, difference(other, truth, instants));
  };
  for (const int bits : {16, 12, 10, 8, 7, 6})
    for (const Sharing& sharing : kSharing)
      for (const Sign sign : {Sign::of_all, Sign::of_some})
        row(fmt::format("{} bits, a scale {}{}", bits, sharing.name, sign == Sign::of_all ? "" : ", unsigned"),
            6.0 * bits + 2.0 * static_cast<double>(sharing.scales),
            [&](const transfer::ProbeTransfer& t) { return roundedSky(t, bits, sharing, sign); });
  for (const int bits : {16, 12, 10, 8})
    row(fmt::format("visibility, {} bits", bits), 3.0 * bits / 8.0,
        [&](const transfer::ProbeTransfer& t) { return roundedVisibility(t, bits); });
}

}  // namespace
}  // namespace welkin::tests

int main(int count, char** arguments) {
  if (count < 2 || count > 3) {
    fmt::print(stderr, "encoding_bench LEVEL.toml [PROBES]\n");
    return EXIT_FAILURE;
  }
  try {
    welkin::tests::run(arguments[1], count > 2 ? static_cast<std::size_t>(std::max(1, std::atoi(arguments[2]))) : 150);
  } catch (const welkin::base::Error& e) {
    fmt::print(stderr, "{}\n", e.what());
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
