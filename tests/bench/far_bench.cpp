// SPDX-License-Identifier: Apache-2.0
// Error of the sky's light beyond the volume, without the far map and with, beside the path tracer, as docs/probes.md
// has it:
//   far_bench LEVEL.toml DIR [HOUR] [POINTS] [PATHS]      DIR: the baked level
// Points are random on all static surfaces and in the air above ground. Also the cost of the map's updates.
#include <fmt/format.h>
#include <tbb/parallel_for.h>
#include <welkin/volume.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <memory>

#include "baked/level_folder.h"
#include "probes/build/subject.h"
#include "probes/fit/fit_points.h"
#include "probes/geometry/tracer.h"
#include "probes/reference/reference.h"
#include "sky/bake/runtime_error.h"
#include "sky/base/error.h"

namespace {

using namespace welkin;
using bake::require;
using f64::Number3;

struct FarPoint {
  fit::FitPoint at;
  double weight = 0.0;                ///< area, m2
  double want = 0.0, variance = 0.0;  ///< the tracer's luminance
};

struct Volume {
  WelkinVolume* volume = nullptr;
  explicit Volume(float fade_m) {
    WelkinVolumeSettings settings{};
    settings.texels[0] = settings.texels[1] = settings.texels[2] = 2;
    settings.bricks = WELKIN_VOLUME_NO_BRICKS;
    settings.far_texels = 1024;
    settings.far_fade_m = fade_m;
    require(welkin_volume_create(&settings, &volume), "welkin_volume_create", welkin_argument_error());
  }
  Volume(const Volume&) = delete;
  Volume& operator=(const Volume&) = delete;
  ~Volume() { welkin_volume_destroy(volume); }
};

/// Mean and root mean square of weighted errors over the weighted mean of the truth, without the tracer's variance.
struct Error {
  double weight = 0.0, mean = 0.0, square = 0.0, truth = 0.0;
  void add(const FarPoint& p, double found) {
    weight += p.weight;
    truth += p.weight * p.want;
    mean += p.weight * (found - p.want);
    square += p.weight * ((found - p.want) * (found - p.want) - p.variance);
  }
  std::string text() const {
    if (weight == 0.0) return "-";
    return fmt::format("{:.1f}, {:+.1f}", 100.0 * std::sqrt(std::max(square / weight, 0.0)) * weight / truth,
                       100.0 * mean / truth);
  }
};

double luminance(const Float3& rgb) {
  return det::luminanceOf(Number3(double{rgb[0]}, double{rgb[1]}, double{rgb[2]}));
}

Float3 floatsOf(const Number3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

struct Group {
  const char* name;
  bool is_air;
  double low_y, high_y;  ///< of the normal
};
constexpr Group kGroups[] = {{"ground and roofs", false, 0.5, 1.1},
                             {"walls", false, -0.5, 0.5},
                             {"undersides", false, -1.1, -0.5},
                             {"all surfaces", false, -1.1, 1.1},
                             {"air, any normal", true, -1.1, 1.1}};

bool isIn(const Group& group, const FarPoint& p, bool is_air) {
  return group.is_air == is_air && p.at.normal.y > group.low_y && p.at.normal.y <= group.high_y;
}

void run(const std::string& file, const std::string& folder, double hour, std::size_t count, std::size_t paths) {
  const build::Subject subject = build::readLevel(file);
  const geometry::Tracer tracer(subject.level->surfaces);
  const reference::DistantLight distant(subject.sky.sky, hour);
  baked::LevelFolder level(folder);
  WelkinSkySample sample{};
  require(welkin_sky_sample(level.sky().get(), hour, &sample), "sample", welkin_argument_error());
  std::vector<FarPoint> points[2];
  Number3 middle(0.0);
  const std::uint32_t sectors = level.level().info().sector_count;
  for (std::uint32_t s = 0; s < sectors; ++s) {
    WelkinSectorEntry entry{};
    level.level().entry(s, entry);
    middle += Number3(64.0 * entry.x + 32.0, 0.0, 64.0 * entry.z + 32.0) / (1.0 * sectors);
    const auto of = fit::pointsOf(tracer, {entry.x, entry.z}, count / sectors + 1, count / sectors / 2 + 1, 77 + s);
    for (const auto& p : of.surface)
      points[0].push_back({p, of.surface_m2 / static_cast<double>(of.surface.size()), 0.0, 0.0});
    for (const auto& p : of.air) points[1].push_back({p, of.air_m2 / static_cast<double>(of.air.size()), 0.0, 0.0});
  }
  for (auto& all : points)
    tbb::parallel_for(std::size_t{0}, all.size(), [&](std::size_t i) {
      FarPoint& p = all[i];
      const auto truth = reference::traceReference(tracer, distant, {}, p.at.position, p.at.normal, {paths, 2, 5});
      p.want = det::luminanceOf(truth.sky.value);
      p.variance = std::pow(det::luminanceOf(truth.sky.standard_error), 2);
    });
  constexpr float kFades[] = {8.0F, 16.0F, 64.0F};
  fmt::print("| points | no light | open sky |");
  std::vector<std::unique_ptr<Volume>> volumes;
  for (const float fade : kFades) {
    volumes.push_back(std::make_unique<Volume>(fade));
    WelkinVolumeUpdate update{};
    const Float3 camera = floatsOf(middle);
    const std::clock_t start = std::clock();
    require(welkin_volume_update(volumes.back()->volume, level.level().get(), &sample, camera.data(), 0, &update),
            "welkin_volume_update", welkin_argument_error());
    if (fade == kFades[0])
      fmt::print(stderr, "the first update takes {:.3f} ms for {} sectors of {} bytes\n",
                 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, sectors,
                 level.level().info().resident_bytes);
    fmt::print(" {:g} m |", fade);
  }
  fmt::print(" probes |\n|---|---|---|---|---|---|---|\n");
  for (const Group& group : kGroups) {
    Error nothing, open, probes, with[std::size(kFades)];
    std::size_t number = 0;
    for (const bool is_air : {false, true}) {
      std::vector<baked::SurfacePoint> at;
      for (const FarPoint& p : points[is_air ? 1 : 0]) at.push_back({p.at.position, p.at.normal});
      const auto looked_up = level.at(at, hour);
      for (std::size_t i = 0; i < at.size(); ++i) {
        const FarPoint& p = points[is_air ? 1 : 0][i];
        if (!isIn(group, p, is_air)) continue;
        ++number;
        const Float3 position = floatsOf(p.at.position), normal = floatsOf(p.at.normal);
        Float3 sky{};
        require(welkin_sky_irradiance(level.sky().get(), &sample, normal.data(), sky.data()), "sky",
                welkin_argument_error());
        nothing.add(p, 0.0);
        open.add(p, luminance(sky));
        probes.add(p, looked_up[i] ? luminance(looked_up[i]->sky) : 0.0);
        for (std::size_t v = 0; v < volumes.size(); ++v) {
          float visibility = 0.0F;
          require(welkin_volume_far_visibility(volumes[v]->volume, position.data(), normal.data(), &visibility),
                  "visibility", welkin_argument_error());
          with[v].add(p, luminance(sky) * double{visibility});
        }
      }
    }
    fmt::print("| {}, {} | {} | {} |", group.name, number, nothing.text(), open.text());
    for (const Error& e : with) fmt::print(" {} |", e.text());
    fmt::print(" {} |\n", probes.text());
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 3) {
    std::fputs("usage: far_bench LEVEL.toml DIR [HOUR] [POINTS] [PATHS]\n", stderr);
    return 1;
  }
  const auto number = [&](int i, double without) { return argc > i ? std::atof(argv[i]) : without; };
  run(argv[1], argv[2], number(3, 12.0), static_cast<std::size_t>(number(4, 2000.0)),
      static_cast<std::size_t>(number(5, 1024.0)));
  return 0;
} catch (const welkin::base::Error& e) {
  fmt::print(stderr, "{}\n", e.what());
  return static_cast<int>(e.status());
}
