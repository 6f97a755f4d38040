// SPDX-License-Identifier: Apache-2.0
// Screen-space occlusion against the path tracer, and its time beside a pass that only reads the G-buffer:
//   occlusion_bench LEVEL.toml X,Y,Z YAW PITCH [PIXELS [RAYS [RUNS]]]
// Errors are of the visibility of a hemisphere, cosine weighted, in percent: mean, rms and worst over random pixels.
// Truth is traced from the surface point of the pixel, within the radius and without end. The G-buffer is traced too.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "probes/build/subject.h"
#include "probes/geometry/directions.h"
#include "probes/geometry/random.h"
#include "probes/geometry/tracer.h"
#include "render/camera.h"
#include "sky/base/error.h"
#include "spirv/kOcclusionDenoise.h"
#include "spirv/kOcclusionRead.h"
#include "tests/vulkan/compute.h"
#include "tests/vulkan/occlusion_view.h"

// The settings of CMakeLists.txt, as a list of SETTING(slices, steps, radius in metres).
#include "occlusion_settings.h"

namespace {

using namespace welkin;
using f64::Number3;

constexpr uint32_t kWidth = 640;
constexpr uint32_t kHeight = 360;
constexpr double kFar_m = 1e9;

struct Setting {
  int slices, steps;
  double radius_m;
  std::span<const uint32_t> find;
};
#define SETTING(slices, steps, radius) Setting{slices, steps, radius, kOcclusionFind##slices##x##steps##_##radius},
const Setting kSettings[] = {WELKIN_OCCLUSION_SETTINGS};
#undef SETTING

double visibility(const geometry::Tracer& tracer, const geometry::Hit& hit, double far_m, std::size_t rays,
                  geometry::Random random) {
  const auto edge = static_cast<std::size_t>(std::sqrt(static_cast<double>(rays)));
  const Number3 from = tracer.leaving(hit);
  std::size_t free = 0;
  for (std::size_t i = 0; i < edge * edge; ++i) {
    const double s = (static_cast<double>(i / edge) + random.unit()) / static_cast<double>(edge);
    const double t = (static_cast<double>(i % edge) + random.unit()) / static_cast<double>(edge);
    free += tracer.occluded(from, geometry::cosineDirection(hit.normal, s, t), far_m) ? 0U : 1U;
  }
  return static_cast<double>(free) / static_cast<double>(edge * edge);
}

/// Errors of the values at `pixels`, or of 1 everywhere if there are none.
std::string errors(const std::vector<float>* values, const std::vector<std::size_t>& pixels,
                   const std::vector<double>& truth) {
  double sum = 0.0;
  double square = 0.0;
  double worst = 0.0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double e = (values != nullptr ? double{(*values)[pixels[i]]} : 1.0) - truth[i];
    sum += e;
    square += e * e;
    worst = std::max(worst, std::abs(e));
  }
  const auto n = static_cast<double>(pixels.size());
  return fmt::format("{:+6.1f} {:5.1f} {:5.1f}", 100.0 * sum / n, 100.0 * std::sqrt(square / n), 100.0 * worst);
}

void run(const std::filesystem::path& file, const render::Camera& camera, const Number3& eye, std::size_t pixels,
         std::size_t rays, int runs) {
  geometry::Surfaces surfaces = build::readLevel(file).level->surfaces;
  std::erase_if(surfaces.triangle,
                [&](const geometry::Triangle& t) { return surfaces.object[t.object].role == geometry::Role::water; });
  const geometry::Tracer tracer(surfaces, eye);
  tests::OcclusionView view = tests::occlusionView(tracer, camera, eye, kWidth, kHeight);
  if (view.seen.empty()) throw base::Error(base::ExitStatus::usage, "the view shows no surface");
  geometry::Random random(15);
  std::vector<std::size_t> chosen;
  std::vector<const geometry::Hit*> hits;
  for (std::size_t i = 0; i < pixels; ++i) {
    const auto& [pixel, hit] =
        view.seen[static_cast<std::size_t>(random.unit() * static_cast<double>(view.seen.size()))];
    chosen.push_back(pixel);
    hits.push_back(&hit);
  }
  const auto truth = [&](double far_m) {
    std::vector<double> values;
    for (std::size_t i = 0; i < chosen.size(); ++i)
      values.push_back(visibility(tracer, *hits[i], far_m, rays, geometry::Random(i)));
    return values;
  };
  const std::vector<double> whole = truth(kFar_m);
  render::VulkanDevice device(false);
  const auto seconds = [&](std::span<const uint32_t> pass) {
    return tests::computeSeconds(device, pass, view.buffer, view.pixels(), runs);
  };
  const auto values = [&](std::span<const uint32_t> pass) {
    return tests::runCompute(device, pass, view.buffer, view.pixels(), 1, VK_NULL_HANDLE, VK_NULL_HANDLE);
  };
  const double read_s = seconds(kOcclusionRead);
  fmt::print("{} x {}, {} pixels of {} with a surface; {}: {:.2f} ms reads the G-buffer, {:.1f} times that denoises\n",
             kWidth, kHeight, pixels, view.seen.size(), device.properties().deviceName, 1e3 * read_s,
             seconds(kOcclusionDenoise) / read_s);
  fmt::print("mean, rms and worst error in %, as found and denoised; time over that of reading\n");
  fmt::print("{:>6} {:>5} {:>8}  {:^19}  {:^19}  {:^19}  {:>5}\n", "slices", "steps", "radius_m", "found, in radius",
             "denoised, in radius", "denoised, all sky", "time");
  double last_m = 0.0;
  std::vector<double> within;
  for (const Setting& s : kSettings) {
    if (s.radius_m != last_m) {
      within = truth(s.radius_m);
      fmt::print("{:>12} {:>8}  {:>19}  {:>19}  {:>19}\n", "1 everywhere", s.radius_m, "",
                 errors(nullptr, chosen, within), errors(nullptr, chosen, whole));
    }
    last_m = s.radius_m;
    const std::vector<float> found = values(s.find);
    view.setFound(found);
    const std::vector<float> denoised = values(kOcclusionDenoise);
    fmt::print("{:>6} {:>5} {:>8}  {}  {}  {}  {:>5.1f}\n", s.slices, s.steps, s.radius_m,
               errors(&found, chosen, within), errors(&denoised, chosen, within), errors(&denoised, chosen, whole),
               seconds(s.find) / read_s);
  }
}

}  // namespace

int main(int count, char** arguments) {
  Number3 eye;
  if (count < 5 || count > 8 || std::sscanf(arguments[2], "%lf,%lf,%lf", &eye.x, &eye.y, &eye.z) != 3) {
    fmt::print(stderr, "occlusion_bench LEVEL.toml X,Y,Z YAW PITCH [PIXELS [RAYS [RUNS]]]\n");
    return 1;
  }
  const auto number = [&](int i, double without) { return count > i ? std::atof(arguments[i]) : without; };
  const render::Camera camera{number(3, 0.0) * f64::kDegree, number(4, 0.0) * f64::kDegree, 60.0 * f64::kDegree};
  try {
    run(arguments[1], camera, eye, static_cast<std::size_t>(number(5, 500)), static_cast<std::size_t>(number(6, 1024)),
        static_cast<int>(number(7, 5)));
  } catch (const base::Error& e) {
    fmt::print(stderr, "{}\n", e.what());
    return static_cast<int>(e.status());
  }
  return 0;
}
