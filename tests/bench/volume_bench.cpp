// SPDX-License-Identifier: Apache-2.0
// Time of the volume's ambient light over a G-buffer with cells along walls, beside that without:
//   volume_bench SHAPE [RUNS]                             seen from inside, of tests/probes/leak_levels.h
//   volume_bench LEVEL.toml X,Y,Z YAW PITCH [RUNS]        a level, baked with few rays
// Also the share of the pixels that the walls concern. What thin walls let through on the device, in eight places of
// each shape, as docs/probes.md has it:
//   volume_bench leaks [SHAPE]                            by walls = "cut"
//   volume_bench rooms [SHAPE]                            by walls = "ignore" and a [[room]]
//   volume_bench door                                     the step of the light at a room's open face, hard and soft
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "probes/build/subject.h"
#include "probes/geometry/tracer.h"
#include "render/camera.h"
#include "sky/base/error.h"
#include "spirv/kVolumeCut.h"
#include "spirv/kVolumeDoors.h"
#include "spirv/kVolumeFar.h"
#include "spirv/kVolumeNear.h"
#include "spirv/kVolumeRead.h"
#include "spirv/kVolumeUncut.h"
#include "tests/vulkan/compute.h"
#include "tests/vulkan/device_volume.h"
#include "tests/vulkan/occlusion_view.h"
#include "tests/vulkan/wall_level.h"

namespace {

using namespace welkin;
using f64::Number3;

constexpr uint32_t kWidth = 640;
constexpr uint32_t kHeight = 360;

/// Positions and normals of the pixels; where nothing is seen, high above.
std::vector<float> pixelsOf(const geometry::Surfaces& surfaces, const Number3& eye, const render::Camera& camera) {
  const geometry::Tracer tracer(surfaces, eye);
  const tests::OcclusionView view = tests::occlusionView(tracer, camera, eye, kWidth, kHeight);
  std::vector<float> pixels(8 * view.pixels(), 0.0F);
  for (std::size_t i = 0; i < view.pixels(); ++i) {
    pixels[8 * i + 1] = 1e4F;
    pixels[8 * i + 5] = 1.0F;
  }
  for (const auto& [pixel, hit] : view.seen)
    for (int a = 0; a < 3; ++a) {
      pixels[8 * pixel + static_cast<std::size_t>(a)] = static_cast<float>(hit.position[a]);
      pixels[8 * pixel + 4 + static_cast<std::size_t>(a)] = static_cast<float>(hit.normal[a]);
    }
  return pixels;
}

/// Processor time of a new volume's first update, without walls and with.
void printFill(tests::OpenedLevel& opened, const WelkinSkySample& sample, const float* at) {
  double least_ms[2] = {1e9, 1e9};
  for (int i = 0; i < 10; ++i) {
    WelkinVolumeSettings settings{};
    settings.bricks = i % 2 == 0 ? WELKIN_VOLUME_NO_BRICKS : 0;
    WelkinVolume* volume = nullptr;
    render::require(welkin_volume_create(&settings, &volume), "welkin_volume_create");
    WelkinVolumeUpdate update{};
    const std::clock_t start = std::clock();
    render::require(welkin_volume_update(volume, opened.level, &sample, at, UINT32_MAX, &update), "update");
    least_ms[i % 2] = std::min(least_ms[i % 2], 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC);
    welkin_volume_destroy(volume);
  }
  fmt::print("the first update takes {:.2f} ms without walls, {:.2f} ms with\n", least_ms[0], least_ms[1]);
}

/// Time from the update to the end of its commands, where the light of all probes changed: relit and filled by the
/// processor and copied, or by the device.
void printRelight(render::VulkanDevice& device, tests::OpenedLevel& opened, const float* at) {
  double least_ms[2] = {1e9, 1e9};
  std::size_t bytes[2] = {};
  for (const int on_device : {0, 1}) {
    const tests::DeviceVolume v(device, on_device != 0 ? WELKIN_VOLUME_DEVICE : WELKIN_VOLUME_RGBA16F, {96, 16, 96});
    WelkinVulkanMemory memory{};
    render::require(welkin_vulkan_volume_memory(v.textures, &memory), "welkin_vulkan_volume_memory");
    bytes[on_device] = memory.images + memory.staging;
    for (int i = 0; i < 12; ++i) {
      const auto start = std::chrono::steady_clock::now();
      const WelkinSkySample sample = opened.relight(i % 2 == 0 ? 9.0 : 12.0);
      v.update(device, opened.level, sample, at, 0);
      const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;
      if (i > 1) least_ms[on_device] = std::min(least_ms[on_device], taken.count());
    }
  }
  fmt::print(
      "another hour takes {:.2f} ms by the processor, {:.2f} ms by the device; {:.1f} and {:.1f} MB of its memory\n",
      least_ms[0], least_ms[1], 1e-6 * static_cast<double>(bytes[0]), 1e-6 * static_cast<double>(bytes[1]));
}

void run(const geometry::Surfaces& surfaces, const Number3& eye, const render::Camera& camera, int runs) {
  const tests::RandomLevel baked = tests::bakedLevel(surfaces);
  tests::OpenedLevel opened(baked);
  render::VulkanDevice device(false);
  const tests::DeviceVolume v(device, WELKIN_VOLUME_RGBA16F, {96, 16, 96});
  const WelkinSkySample sample = opened.relight(12.0);
  const float at[3] = {static_cast<float>(eye.x), static_cast<float>(eye.y), static_cast<float>(eye.z)};
  const WelkinVolumeUpdate update = v.update(device, opened.level, sample, at, 0);
  printFill(opened, sample, at);
  printRelight(device, opened, at);
  const std::vector<float> pixels = pixelsOf(surfaces, eye, camera);
  const std::size_t outputs = pixels.size() / 2;
  const VkDescriptorSetLayout layout = welkin_vulkan_volume_descriptor_set_layout(v.textures);
  const VkDescriptorSet set = welkin_vulkan_volume_descriptor_set(v.textures, 0);
  const auto seconds = [&](std::span<const uint32_t> pass) {
    return tests::computeSeconds(device, pass, pixels, outputs, 1, 4, layout, set);
  };
  double read_s = 1e9, uncut_s = 1e9, cut_s = 1e9, doors_s = 1e9, far_s = 1e9;
  for (int i = 0; i < runs; ++i) {  // in turn, so that other work on the machine delays all alike
    read_s = std::min(read_s, seconds(kVolumeRead));
    uncut_s = std::min(uncut_s, seconds(kVolumeUncut));
    cut_s = std::min(cut_s, seconds(kVolumeCut));
    doors_s = std::min(doors_s, seconds(kVolumeDoors));
    far_s = std::min(far_s, seconds(kVolumeFar));
  }
  const std::vector<float> near = tests::runCompute(device, kVolumeNear, pixels, outputs, 4, layout, set);
  std::size_t count = 0;
  for (std::size_t i = 0; i < near.size(); i += 4) count += near[i] > 0.0F ? 1 : 0;
  fmt::print("{} x {}, {}: {:.2f} ms reads the G-buffer; {:.2f} ms without walls, {:.2f} ms with: {:.2f} times\n",
             kWidth, kHeight, device.properties().deviceName, 1e3 * read_s, 1e3 * uncut_s, 1e3 * cut_s,
             cut_s / uncut_s);
  fmt::print("{:.2f} ms with walls and doors, of which there are none: {:.2f} times\n", 1e3 * doors_s,
             doors_s / uncut_s);
  fmt::print("{:.2f} ms with walls and the far map beyond: {:.2f} times that with walls\n", 1e3 * far_s, far_s / cut_s);
  fmt::print("{:.1f} % of the pixels are of a brick; {} sectors, {} bricks\n",
             400.0 * static_cast<double>(count) / static_cast<double>(near.size()), baked.sector.size(), update.bricks);
}

/// Light at surfaces above that of the query, over the open ground's: mean and worst, without walls and with.
void printLeaks(render::VulkanDevice& device, const std::string& shape, bool rooms) {
  constexpr std::uint64_t kPlaces = 8;
  double mean[2] = {}, worst[2] = {}, below = 0.0;
  std::uint32_t bricks = 0;
  for (std::uint64_t seed = 0; seed < kPlaces; ++seed) {
    const tests::LeakLevel place = tests::leakLevel(shape, seed);
    const placement::PlacementSettings settings = rooms ? tests::roomsOnly(place) : placement::PlacementSettings();
    tests::OpenedLevel opened(tests::bakedLevel(place.surfaces, {{0, 0}}, 0, settings));
    const tests::DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
    const WelkinSkySample sample = opened.relight(12.0);
    const float camera[3] = {30, 4, 40};
    const WelkinVolumeUpdate update = v.update(device, opened.level, sample, camera, 0);
    bricks = std::max(bricks, update.bricks);
    const float ground[2][1][3] = {{{4, 0, 4}}, {{0, 1, 0}}};
    float open[1][3];
    render::require(welkin_level_irradiance(opened.level, 1, ground[0], ground[1], open, nullptr), "irradiance");
    std::vector<float> points;
    for (const tests::LeakPoint& p : place.point) {
      if (p.push_m != 1.0) continue;
      for (const Number3& n : {p.position, p.normal})
        points.insert(points.end(), {static_cast<float>(n.x), static_cast<float>(n.y), static_cast<float>(n.z), 0.0F});
    }
    const std::size_t count = points.size() / 8;
    const std::span<const uint32_t> passes[2] = {kVolumeUncut, kVolumeCut};
    for (int pass = 0; pass < 2; ++pass) {
      const auto found = tests::runCompute(device, passes[pass], points, 4 * count, 4,
                                           welkin_vulkan_volume_descriptor_set_layout(v.textures),
                                           welkin_vulkan_volume_descriptor_set(v.textures, 0));
      for (std::size_t i = 0; i < count; ++i) {
        const float* p = &points[8 * i];
        const float at[2][1][3] = {{{p[0], p[1], p[2]}}, {{p[4], p[5], p[6]}}};
        float query[1][3];
        render::require(welkin_level_irradiance(opened.level, 1, at[0], at[1], query, nullptr), "irradiance");
        const double above = (double{found[4 * i + 1]} - double{query[0][1]}) / double{open[0][1]};
        mean[pass] += std::max(above, 0.0) / static_cast<double>(count * kPlaces);
        if (above > worst[pass] && above > 0.02 && pass == 1)
          fmt::print(stderr, "{} {}: {} {} {}, {} {} {}: {}\n", shape, seed, p[0], p[1], p[2], p[4], p[5], p[6], above);
        worst[pass] = std::max(worst[pass], above);
        if (pass == 1) below = std::max(below, -above);
      }
    }
  }
  fmt::print("| {} | {:.3f} | {:.3f} | {:.4f} | {:.4f} | {:.4f} | {} |\n", shape, mean[0], worst[0], mean[1], worst[1],
             below, bricks);
  std::fflush(stdout);
}

/// A door of a place's room in the face where it has no wall, `depth_m` long, half of it outside.
placement::RoomDoor doorOf(const geometry::Box& room, double depth_m) {
  return {room,
          {Number3(room.low.x, room.low.y, room.high.z - 0.5 * depth_m),
           Number3(room.high.x, room.high.y, room.high.z + 0.5 * depth_m)}};
}

/// The largest step of the light within 1 cm on a way through a door, over the open ground's, by the query and on the
/// device.
std::array<double, 2> stepAtDoor(render::VulkanDevice& device, std::uint64_t seed, bool rooms, double depth_m) {
  constexpr int kPoints = 600;
  constexpr double kStep_m = 0.01;
  const tests::LeakLevel place = tests::leakLevel("room with a door", seed);
  placement::PlacementSettings settings = rooms ? tests::roomsOnly(place) : placement::PlacementSettings();
  if (depth_m > 0.0) settings.door = {doorOf(place.room[0], depth_m)};
  tests::OpenedLevel opened(tests::bakedLevel(place.surfaces, {{0, 0}}, 0, settings));
  const tests::DeviceVolume v(device, WELKIN_VOLUME_RGBA16F);
  const float camera[3] = {30, 4, 40};
  v.update(device, opened.level, opened.relight(12.0), camera, 0);
  const Number3 middle = 0.5 * (place.room[0].low + place.room[0].high);
  std::vector<float> points;
  const auto add = [&](const Number3& p) {
    points.insert(points.end(), {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), 0.0F});
    points.insert(points.end(), {0.0F, 1.0F, 0.0F, 0.0F});
  };
  for (int i = 0; i < kPoints; ++i)
    add(Number3(middle.x, place.room[0].low.y + 0.1, place.room[0].high.z + kStep_m * (i - kPoints / 2)));
  add(Number3(4.0, 0.0, 4.0));
  const auto found = tests::runCompute(device, kVolumeDoors, points, points.size() / 2, 4,
                                       welkin_vulkan_volume_descriptor_set_layout(v.textures),
                                       welkin_vulkan_volume_descriptor_set(v.textures, 0));
  std::array<double, 2> most{};
  double before = 0.0;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const float* p = &points[8 * i];
    const float at[2][1][3] = {{{p[0], p[1], p[2]}}, {{p[4], p[5], p[6]}}};
    float query[1][3];
    render::require(welkin_level_irradiance(opened.level, 1, at[0], at[1], query, nullptr), "irradiance");
    if (i > 0) most[0] = std::max(most[0], std::abs(double{query[0][1]} - before));
    if (i > 0) most[1] = std::max(most[1], std::abs(double{found[4 * i + 1]} - double{found[4 * i - 3]}));
    before = double{query[0][1]};
  }
  for (double& step : most) step /= double{found[4 * kPoints + 1]};
  return most;
}

void printDoor(render::VulkanDevice& device) {
  struct Way {
    const char* name;
    bool rooms;
    double depth_m;
  };
  for (const Way& way : {Way{"walls", false, 0.0}, Way{"a room", true, 0.0}, Way{"a room, soft over 1 m", true, 1.0},
                         Way{"a room, soft over 2 m", true, 2.0}, Way{"a room, soft over 4 m", true, 4.0}}) {
    std::array<double, 2> most{};
    for (std::uint64_t seed = 0; seed < 8; ++seed) {
      const auto step = stepAtDoor(device, seed, way.rooms, way.depth_m);
      for (std::size_t i = 0; i < 2; ++i) most[i] = std::max(most[i], step[i]);
    }
    fmt::print("through a door, by {}: {:.4f} in 1 cm at most by the query, {:.4f} on the device\n", way.name, most[0],
               most[1]);
    std::fflush(stdout);
  }
}

/// The middle of the points of a shape.
Number3 middleOf(const tests::LeakLevel& level) {
  Number3 sum(0.0);
  for (const tests::LeakPoint& p : level.point) sum += p.position;
  return sum / static_cast<double>(level.point.size());
}

}  // namespace

int main(int count, char** arguments) {
  const auto number = [&](int i, double without) { return count > i ? std::atof(arguments[i]) : without; };
  const auto camera = [](double yaw, double pitch) {
    return render::Camera{yaw * f64::kDegree, pitch * f64::kDegree, 60.0 * f64::kDegree};
  };
  Number3 eye;
  try {
    if (count >= 2 && (arguments[1] == std::string("leaks") || arguments[1] == std::string("rooms"))) {
      render::VulkanDevice device(false);
      for (const std::string& shape : tests::leakShapes())
        if (count < 3 || shape.find(arguments[2]) != std::string::npos)
          printLeaks(device, shape, arguments[1] == std::string("rooms"));
    } else if (count == 2 && arguments[1] == std::string("door")) {
      render::VulkanDevice device(false);
      printDoor(device);
    } else if (count == 2 || count == 3) {
      const tests::LeakLevel level = tests::leakLevel(arguments[1], 0);
      run(level.surfaces, middleOf(level), camera(60.0, -10.0), static_cast<int>(number(2, 20)));
    } else if ((count == 5 || count == 6) && std::sscanf(arguments[2], "%lf,%lf,%lf", &eye.x, &eye.y, &eye.z) == 3) {
      geometry::Surfaces surfaces = build::readLevel(arguments[1]).level->surfaces;
      run(surfaces, eye, camera(number(3, 0.0), number(4, 0.0)), static_cast<int>(number(5, 20)));
    } else {
      fmt::print(stderr,
                 "volume_bench SHAPE [RUNS], or LEVEL.toml X,Y,Z YAW PITCH [RUNS], or leaks|rooms [SHAPE], or door\n");
      return 1;
    }
  } catch (const base::Error& e) {
    fmt::print(stderr, "{}\n", e.what());
    return static_cast<int>(e.status());
  }
  return 0;
}
