// SPDX-License-Identifier: Apache-2.0
// The error of a baked level against the path tracer, at random points of its surfaces and at 8 hours:
//   level_error LEVEL.toml DIR [POINTS [SAMPLES]]
// Errors are of luminance, over the horizontal irradiance of the open sky at that hour; the sky's also by
// SkyBounce::fitted. A second table has the whole ambient light by simpler means: the open sky for the normal, one
// colour, and none.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "probes/build/level_bake.h"
#include "probes/build/subject.h"
#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "probes/placement/validity.h"
#include "probes/reference/reference.h"
#include "probes/sectors/level_light.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/model/projection.h"

namespace welkin::study {

using f64::Number3;

namespace {

struct SurfacePoint {
  Number3 position, normal;
  std::optional<std::pair<geometry::SectorId, std::size_t>> probe = {};  ///< the probe that it stands at
};

/// Random points of probes with normals over the sphere.
std::vector<SurfacePoint> pointsAtProbes(const std::vector<sectors::SectorFile>& sectors, std::size_t count) {
  std::vector<SurfacePoint> all;
  for (const sectors::SectorFile& file : sectors) {
    const transfer::SectorProbes probes = transfer::decodedProbes(file.probes, file.id);
    for (std::size_t i = 0; i < probes.position.size(); ++i)
      all.push_back({probes.position[i], {}, std::pair(file.id, i)});
  }
  geometry::Random random(7);
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < count && !all.empty(); ++i) {
    points.push_back(all[static_cast<std::size_t>(random.unit() * static_cast<double>(all.size()))]);
    const double s = random.unit();
    points.back().normal = geometry::sphereDirection(s, random.unit());
  }
  return points;
}

/// Points spread over the fronts of static surfaces by area, in air, within the sectors.
std::vector<SurfacePoint> pointsOn(const geometry::Surfaces& s, const geometry::Tracer& tracer,
                                   const sectors::LevelLight& light, std::size_t count, std::size_t& without) {
  std::vector<double> sum;
  for (const geometry::Triangle& t : s.triangle) {
    const auto load = [&](int i) {
      const auto& p = s.position[t.vertex[static_cast<std::size_t>(i)]];
      return Number3(double{p[0]}, double{p[1]}, double{p[2]});
    };
    const Number3 normal = cross(load(1) - load(0), load(2) - load(0));
    const bool is_static = s.object[t.object].role == geometry::Role::fixed;
    sum.push_back((sum.empty() ? 0.0 : sum.back()) + (is_static ? std::sqrt(dot(normal, normal)) : 0.0));
  }
  geometry::Random random(20261124);
  std::vector<SurfacePoint> points;
  for (int tries = 0; points.size() < count && tries < 1000000; ++tries) {
    const auto found = std::upper_bound(sum.begin(), sum.end(), random.unit() * sum.back());
    const geometry::Triangle& t = s.triangle[static_cast<std::size_t>(found - sum.begin())];
    const auto load = [&](std::size_t i) {
      const auto& p = s.position[t.vertex[i]];
      return Number3(double{p[0]}, double{p[1]}, double{p[2]});
    };
    const double u = std::sqrt(random.unit());
    const double v = random.unit();
    const Number3 position = load(0) * (1.0 - u) + load(1) * (u * (1.0 - v)) + load(2) * (u * v);
    const Number3 normal = geometry::unit(cross(load(1) - load(0), load(2) - load(0)));
    constexpr double kOff_m = 0.05;
    const Number3 off = position + normal * kOff_m;
    const auto above = tracer.closest(off, {0, 1, 0}, 1e9);
    const bool wet = above && s.object[s.triangle[above->triangle].object].role == geometry::Role::water;
    if (wet || placement::insideGeometry(tracer, off)) continue;
    if (!light.at(position, normal)) {
      ++without;
      continue;
    }
    points.push_back({position, normal, {}});
  }
  return points;
}

struct ErrorStatistics {
  double square = 0.0, bias = 0.0, worst = 0.0;
  std::size_t count = 0;
  void add(double e) {
    square += e * e;
    bias += e;
    worst = std::max(worst, std::abs(e));
    ++count;
  }
  std::string text() const {
    const double n = static_cast<double>(std::max<std::size_t>(count, 1));
    return fmt::format("{:5.1f} {:+5.1f} {:5.1f}", 100.0 * std::sqrt(square / n), 100.0 * bias / n, 100.0 * worst);
  }
};

/// A table of errors: a row an hour, a column a way.
template <std::size_t N>
class Table {
 public:
  Table(const char* title, const std::array<const char*, N>& column) {
    text_ = fmt::format("{}\n{:>5}", title, "hour");
    for (const char* name : column) text_ += fmt::format("  {:^17}", name);
    text_ += '\n';
  }
  void add(std::size_t column, double error) {
    hour_[column].add(error);
    all_[column].add(error);
  }
  void endHour(double time_h) {
    row(fmt::format("{}", time_h), hour_);
    hour_ = {};
  }
  void print() {
    row("all", all_);
    fmt::print("{}", text_);
  }

 private:
  void row(const std::string& name, const std::array<ErrorStatistics, N>& errors) {
    text_ += fmt::format("{:>5}", name);
    for (const ErrorStatistics& e : errors) text_ += "  " + e.text();
    text_ += '\n';
  }

  std::string text_;
  std::array<ErrorStatistics, N> hour_, all_;
};

/// The open sky's irradiance, and its light from the ground, with nothing in the way.
class OpenSky {
 public:
  OpenSky(const model::Sky& sky, double time_h)
      : instant_(sky, time_h), projector_(sky.luminance, 2, 1e-6), ground_(sky.ground_albedo) {
    lit_ = projector_.irradiance(instant_, {0, 1, 0}) * instant_.intensity();
    below_ = lit_;
    for (const model::Light* light : {&sky.sun, sky.moon ? &*sky.moon : nullptr}) {
      if (light == nullptr) continue;
      below_ += f64::levelIrradiance(light->normalIrradianceAt(time_h), light->path.directionAt(time_h));
    }
  }
  Number3 horizontal() const { return lit_; }
  Number3 at(const Number3& normal) const {
    const double down = (1.0 - normal.y) / 2.0;
    return projector_.irradiance(instant_, normal) * instant_.intensity() +
           Number3(ground_.x * below_.x, ground_.y * below_.y, ground_.z * below_.z) * down;
  }
  /// The mean over all normals.
  Number3 mean() const {
    Number3 sum(0.0);
    constexpr int kNormals = 200;
    for (int i = 0; i < kNormals; ++i) {
      const double turns = 0.6180339887498949 * i;  // Fibonacci's spiral
      sum += at(geometry::sphereDirection((i + 0.5) / kNormals, turns - std::floor(turns))) / double{kNormals};
    }
    return sum;
  }

 private:
  model::SkyInstant instant_;
  model::SkyProjector projector_;
  Number3 ground_, lit_{0.0}, below_{0.0};
};

void compare(const geometry::Tracer& tracer, const model::Sky& sky, const build::BakeSection& section,
             const std::vector<sectors::SectorFile>& sectors, const std::vector<SurfacePoint>& points,
             std::size_t samples) {
  Table<4> parts("by the probes", {"sky", "sky, fitted", "sun bounce", "total"});
  Table<4> ways("all of the ambient light", {"probes", "open sky", "one colour", "nothing"});
  for (int i = 0; i < 8; ++i) {
    const double time_h = 3.0 * i;
    const sectors::LevelLight light(sectors, sky, time_h, section.scale);
    const sectors::LevelLight fitted(sectors, sky, time_h, section.scale, transfer::SkyBounce::fitted);
    const reference::DistantLight distant(sky, time_h);
    const OpenSky open(sky, time_h);
    const Number3 mean = open.mean();
    const double unit = det::luminanceOf(open.horizontal());
    std::uint64_t seed = static_cast<std::uint64_t>(i) << 32;
    for (const SurfacePoint& point : points) {
      const auto irradianceBy = [&](const sectors::LevelLight& l) {
        return point.probe ? l.ofProbe(point.probe->first, point.probe->second, point.normal)
                           : *l.at(point.position, point.normal);
      };
      const sectors::LevelIrradiance got = irradianceBy(light);
      const auto want = reference::traceReference(tracer, distant, {}, point.position, point.normal,
                                                  {samples, section.transfer.bounces, seed++});
      const auto error = [&](const Number3& difference) { return det::luminanceOf(difference) / unit; };
      parts.add(0, error(got.sky - want.sky.value));
      parts.add(1, error(irradianceBy(fitted).sky - want.sky.value));
      parts.add(2, error(got.sun_bounce - want.sun_bounce.value));
      parts.add(3, error(got.total() - want.total.value));
      ways.add(0, error(got.total() - want.total.value));
      ways.add(1, error(open.at(point.normal) - want.total.value));
      ways.add(2, error(mean - want.total.value));
      ways.add(3, error(Number3(0.0) - want.total.value));
    }
    parts.endHour(time_h);
    ways.endHour(time_h);
  }
  parts.print();
  ways.print();
}

void run(const std::filesystem::path& file, const std::filesystem::path& folder, std::size_t count,
         std::size_t samples) {
  const build::Subject subject = build::readLevel(file);
  const model::Sky& sky = subject.sky.sky;
  const build::BakeSection& section = subject.level->section;
  const geometry::Surfaces& surfaces = subject.level->surfaces;
  const geometry::Tracer tracer(surfaces);
  std::vector<sectors::SectorFile> sectors;
  std::size_t bytes = 0;
  std::size_t probes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "sectors")) {
    const auto data = base::readFile(entry.path());
    sectors.push_back(sectors::decodeSector(data, entry.path().string()));
    bytes += data.size();
    probes += sectors.back().probes.probes();
  }
  std::size_t without = 0;
  const auto points = pointsOn(surfaces, tracer, sectors::LevelLight(sectors, sky, 12.0), count, without);
  fmt::print("{} sectors, {} probes, {} bytes; {} points, {} more had no probe\n", sectors.size(), probes, bytes,
             points.size(), without);
  fmt::print("rms, bias and worst in % of the open sky's horizontal irradiance\non surfaces:\n");
  compare(tracer, sky, section, sectors, points, samples);
  fmt::print("at the probes, any normal:\n");
  compare(tracer, sky, section, sectors, pointsAtProbes(sectors, count), samples);
}

}  // namespace
}  // namespace welkin::study

int main(int count, char** arguments) {
  if (count < 3 || count > 5) {
    fmt::print(stderr, "level_error LEVEL.toml DIR [POINTS [SAMPLES]]\n");
    return 1;
  }
  try {
    welkin::study::run(arguments[1], arguments[2], count > 3 ? std::strtoull(arguments[3], nullptr, 10) : 200,
                       count > 4 ? std::strtoull(arguments[4], nullptr, 10) : 4096);
  } catch (const welkin::base::Error& e) {
    fmt::print(stderr, "{}\n", e.what());
    return static_cast<int>(e.status());
  }
  return 0;
}
