// SPDX-License-Identifier: Apache-2.0
// How a sector's time grows with its triangles: n, 2 n and 4 n of each kind, on one thread.
//   growth_bench N [RAYS]
#include <fmt/format.h>
#include <tbb/global_control.h>

#include <chrono>
#include <cmath>
#include <cstdlib>

#include "probes/geometry/canonical_order.h"
#include "probes/geometry/random.h"
#include "probes/geometry/reach.h"
#include "probes/placement/placement.h"
#include "probes/transfer/trace_transfer.h"
#include "sky/base/error.h"

namespace {

using namespace welkin;
using f64::Number3;
using geometry::Random;

Number3 somewhere(Random& random, double size_m) {
  const double x = random.unit();
  const double y = random.unit();
  return Number3(x, y, random.unit()) * size_m;
}

void add(geometry::Surfaces& s, const Number3& a, const Number3& b, const Number3& c) {
  const auto first = static_cast<std::uint32_t>(s.position.size());
  for (const Number3& p : {a, b, c}) s.position.push_back({p.x, p.y, p.z});
  s.triangle.push_back({{first, first + 1, first + 2}, 0, 0});
}

/// Triangles across the whole sector.
void addSoup(geometry::Surfaces& s, std::size_t n, Random& random) {
  for (std::size_t i = 0; i < n; ++i) {
    const Number3 a = somewhere(random, geometry::kSector_m);
    const Number3 b = somewhere(random, geometry::kSector_m);
    add(s, a, b, somewhere(random, geometry::kSector_m));
  }
}

/// Triangles of a metre.
void addCrumbs(geometry::Surfaces& s, std::size_t n, Random& random) {
  for (std::size_t i = 0; i < n; ++i) {
    const Number3 at = somewhere(random, geometry::kSector_m - 1.0);
    const Number3 a = at + somewhere(random, 1.0);
    const Number3 b = at + somewhere(random, 1.0);
    add(s, a, b, at + somewhere(random, 1.0));
  }
}

/// Blades a millimetre wide, as long as the sector.
void addSlivers(geometry::Surfaces& s, std::size_t n, Random& random) {
  for (std::size_t i = 0; i < n; ++i) {
    const Number3 a = somewhere(random, geometry::kSector_m);
    const Number3 b = somewhere(random, geometry::kSector_m);
    add(s, a, b, b + somewhere(random, 1e-3));
  }
}

/// A fan: one corner in all triangles of the ground.
void addFan(geometry::Surfaces& s, std::size_t n, Random& /*random*/) {
  const auto at = [&](std::size_t i) {
    const double angle = 1.5 * static_cast<double>(i) / static_cast<double>(n);
    return Number3(60.0 * std::sin(angle), 0.0, 60.0 * std::cos(angle));
  };
  for (std::size_t i = 0; i < n; ++i) add(s, Number3(0.0), at(i), at(i + 1));
}

/// The same triangle again and again.
void addCopies(geometry::Surfaces& s, std::size_t n, Random& /*random*/) {
  for (std::size_t i = 0; i < n; ++i) add(s, Number3(0.0), {0, 0, 60}, {60, 0, 0});
}

/// Hills on a square lattice.
void addGround(geometry::Surfaces& s, std::size_t n, Random& random) {
  const auto side = static_cast<std::size_t>(std::sqrt(0.5 * static_cast<double>(n)));
  std::vector<double> height;
  for (std::size_t i = 0; i < (side + 1) * (side + 1); ++i) height.push_back(0.3 * random.unit());
  const double step_m = geometry::kSector_m / static_cast<double>(side);
  const auto at = [&](std::size_t i, std::size_t k) {
    return Number3(step_m * static_cast<double>(i), height[i + (side + 1) * k], step_m * static_cast<double>(k));
  };
  for (std::size_t k = 0; k < side; ++k)
    for (std::size_t i = 0; i < side; ++i) {
      add(s, at(i, k), at(i, k + 1), at(i + 1, k + 1));
      add(s, at(i, k), at(i + 1, k + 1), at(i + 1, k));
    }
}

double secondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

struct Cost {
  double order_s = 0.0, scene_s = 0.0, placement_s = 0.0, rays_s = 0.0;
  std::size_t probes = 0;
  double all() const { return order_s + scene_s + placement_s + rays_s; }
};

Cost costOf(geometry::Surfaces surfaces, std::size_t rays) {
  Cost cost;
  auto start = std::chrono::steady_clock::now();
  const geometry::OrderedLevel level = geometry::orderedLevel(std::move(surfaces));
  geometry::hashAbout(level.surfaces, level.content, {0, 0}, geometry::columnOf({0, 0}, 128.0));
  cost.order_s = secondsSince(start);
  start = std::chrono::steady_clock::now();
  const geometry::Tracer tracer(level.surfaces);
  cost.scene_s = secondsSince(start);
  start = std::chrono::steady_clock::now();
  placement::PlacementReport report;
  const geometry::PlacedSector placed = placement::placeSector(tracer, {0, 0}, {}, report);
  cost.placement_s = secondsSince(start);
  start = std::chrono::steady_clock::now();
  transfer::TransferSettings settings;
  settings.rays = rays;
  transfer::TransferTracer(tracer, settings).trace(placed);
  cost.rays_s = secondsSince(start);
  cost.probes = placed.probe.size();
  return cost;
}

void run(std::size_t n, std::size_t rays) {
  const std::pair<const char*, void (*)(geometry::Surfaces&, std::size_t, Random&)> kinds[] = {
      {"ground", addGround}, {"fan", addFan},       {"copies", addCopies},
      {"soup", addSoup},     {"crumbs", addCrumbs}, {"slivers", addSlivers}};
  fmt::print("{:<8} {:>9} {:>7} {:>9} {:>9} {:>9} {:>9} {:>9} {:>6}\n", "kind", "triangles", "probes", "order s",
             "scene s", "placing s", "rays s", "all s", "growth");
  for (const auto& [name, fill] : kinds) {
    double before = 0.0;
    for (const std::size_t times : {1U, 2U, 4U}) {
      geometry::Surfaces s;
      s.object.push_back({name, geometry::Role::fixed});
      s.material.emplace_back();
      Random random(20261129);
      fill(s, n * times, random);
      const Cost c = costOf(std::move(s), rays);
      fmt::print(
          "{:<8} {:>9} {:>7} {:>9.3f} {:>9.3f} {:>9.3f} {:>9.3f} "
          "{:>9.3f} {:>6}\n",
          name, n * times, c.probes, c.order_s, c.scene_s, c.placement_s, c.rays_s, c.all(),
          before > 0.0 ? fmt::format("{:.2f}", c.all() / before) : "");
      before = c.all();
    }
  }
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2 || count > 3) {
    fmt::print(stderr, "growth_bench N [RAYS]\n");
    return 1;
  }
  try {
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    run(std::strtoul(arguments[1], nullptr, 10), count > 2 ? std::strtoul(arguments[2], nullptr, 10) : 64);
  } catch (const base::Error& e) {
    fmt::print(stderr, "{}\n", e.what());
    return static_cast<int>(e.status());
  }
  return 0;
}
