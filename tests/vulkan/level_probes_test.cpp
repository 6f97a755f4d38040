// SPDX-License-Identifier: Apache-2.0
// Probes in the level picture against the CPU. The test's own ray finds the sphere's normal at every pixel. Its
// radiance is the sum of the four irradiances, weighted by shadingWeights, over pi.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <optional>

#include "probes/geometry/random.h"
#include "probes/loader/read_scene.h"
#include "probes/transfer/transfer_basis.h"
#include "render/level_view.h"
#include "test_sky.h"
#include "tests/folder.h"
#include "tests/gltf_text.h"
#include "worst.h"

namespace welkin::tests {
namespace {

using f64::Number3;
using render::Camera;
using render::FloatImage;
using render::ProbeSphere;
using transfer::kDirections;

/// The points where the CPU's ray and the device's meet the sphere differ by rounding. That is 2e-7 of the ray, times
/// the distance over the radius, 10, times the slope of the normal, below 5 inside of kInside. The four irradiances
/// differ by as much as their sum.
constexpr double kTolerance = 2e-5;
constexpr double kInside = 0.98;  ///< share of the radius; pixels farther out are not compared

constexpr uint32_t kProbeSize = 96;
const Camera kNorth{0.0, 0.0, 0.5};
const Number3 kEye(0.2, 2.0, 3.0);

/// A wall of 2 x 2 m in the plane z = -3, in front of everything north of it.
level::Scene wall() {
  const Folder folder;
  GltfText gltf;
  gltf.addNode(gltf.addMesh(boxMesh(), gltf.addMaterial({0.5, 0.5, 0.5})),
               {{"scale", {1, 1, 0.1}}, {"translation", {0, 2, -3}}});
  level::LevelFile level;
  level.geometry.push_back({folder.write("a.gltf", gltf.text()), {}, geometry::Role::fixed, {}});
  return loader::readScene(level);
}

struct ProbeStage {
  ProbeStage() : bytes(testSkyFile({})), sky(openTestSky(bytes)), device(true), scene(wall()) {}

  FloatImage draw(const std::vector<ProbeSphere>& probes, const Camera& camera = kNorth, const Number3& eye = kEye) {
    if (!view)
      view = std::make_unique<render::LevelView>(
          device, sky, scene, render::LevelOptions{.waves = false, .mist_per_m = 0.0, .shadow_size = 64});
    view->setTime(10.0);
    view->setProbes(probes);
    return view->draw(kProbeSize, kProbeSize, camera, eye);
  }

  std::vector<std::byte> bytes;
  Sky sky;
  render::VulkanDevice device;
  level::Scene scene;
  std::unique_ptr<render::LevelView> view;
};

/// A probe with a different irradiance in every direction and channel.
ProbeSphere uneven(const Number3& position) {
  return {{static_cast<float>(position.x), static_cast<float>(position.y), static_cast<float>(position.z)},
          {{1.0F, 0.2F, 0.7F}, {0.3F, 0.9F, 0.5F}, {0.6F, 0.4F, 0.1F}, {0.15F, 0.25F, 0.35F}}};
}

Number3 numberOf(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

Number3 radianceOf(const ProbeSphere& probe, const Number3& normal) {
  const auto weight = transfer::shadingWeights(normal);
  Number3 sum;
  for (std::size_t b = 0; b < kDirections; ++b) sum += numberOf(probe.irradiance[b]) * weight[b];
  return Number3(std::max(sum.x, 0.0), std::max(sum.y, 0.0), std::max(sum.z, 0.0)) / f64::kPi;
}

Number3 rayAt(const Camera& camera, uint32_t x, uint32_t y) {
  const auto m = render::inverseViewProjection(camera, 1.0);
  const double ndc[2] = {2.0 * (x + 0.5) / kProbeSize - 1.0, 2.0 * (y + 0.5) / kProbeSize - 1.0};
  Number3 ray;
  for (int i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i);
    ray[i] = ndc[0] * double{m[at]} + ndc[1] * double{m[4 + at]} + double{m[12 + at]};
  }
  return ray / std::sqrt(dot(ray, ray));
}

/// A ray and the sphere: least distance from the centre over the radius, and the normal where they meet.
struct Meeting {
  double nearness;
  std::optional<Number3> normal;
};

Meeting meet(const ProbeSphere& probe, const Number3& eye, const Number3& ray) {
  const Number3 centre = numberOf(probe.position) - eye;
  const double along = dot(centre, ray);
  const double miss_2 = dot(centre, centre) - along * along;
  const double left = WELKIN_PROBE_RADIUS * WELKIN_PROBE_RADIUS - miss_2;
  const double nearness = along > 0.0 ? std::sqrt(std::max(miss_2, 0.0)) / WELKIN_PROBE_RADIUS : 1e9;
  if (!(left > 0.0) || along <= 0.0) return {nearness, std::nullopt};
  return {nearness, (ray * (along - std::sqrt(left)) - centre) / WELKIN_PROBE_RADIUS};
}

}  // namespace

TEST_CASE("LevelProbes, SphereHasTheIrradianceOfItsProbeAtEveryNormal", "[vulkan]") {
  ProbeStage stage;
  const ProbeSphere probe = uneven({0.3, 2.1, 0.0});
  struct View {
    Camera camera;
    Number3 eye;
  };
  // From the south, from the north-east below, and from straight above.
  for (const View& v : {View{kNorth, kEye}, View{{-2.3, 0.35, 0.6}, {2.4, 1.0, -1.9}},
                        View{{0.4, -f64::kHalfPi, 0.5}, {0.2, 5.0, 0.1}}}) {
    const FloatImage without = stage.draw({}, v.camera, v.eye);
    const FloatImage image = stage.draw({probe}, v.camera, v.eye);
    Worst worst;
    std::size_t beside = 0;
    for (uint32_t y = 0; y < kProbeSize; ++y)
      for (uint32_t x = 0; x < kProbeSize; ++x) {
        const Meeting at = meet(probe, v.eye, rayAt(v.camera, x, y));
        if (at.normal && at.nearness < kInside) {
          const Number3 expected = radianceOf(probe, *at.normal);
          for (int c = 0; c < 3; ++c)
            worst.compare(double{image.pixel(x, y)[c]}, expected[c], 1.0 / f64::kPi,
                          [&] { return "pixel " + std::to_string(x) + "," + std::to_string(y); });
          CHECK(image.pixel(x, y)[3] == 1.0F);
        } else if (at.nearness > 2.0 - kInside) {
          ++beside;
          REQUIRE(std::equal(image.pixel(x, y), image.pixel(x, y) + 4, without.pixel(x, y)));
        }
      }
    WARN("worst " << worst.error << " at " << worst.where << " of " << worst.count);
    CHECK(worst.count > 1000);
    CHECK(beside > 1000);
    CHECK(worst.error < kTolerance);
  }
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelProbes, NothingIsBelowZero", "[vulkan]") {
  ProbeStage stage;
  ProbeSphere probe = uneven({0.2, 2.0, 0.0});
  for (auto& channel : probe.irradiance[1]) channel = 0.0F;
  for (auto& channel : probe.irradiance[3]) channel = 0.0F;
  for (auto& channel : probe.irradiance[2]) channel = -0.5F;  // Bounced light from four coefficients may be negative.
  const FloatImage image = stage.draw({probe});
  std::size_t black = 0;
  for (uint32_t i = 0; i < kProbeSize * kProbeSize; ++i) {
    const float* p = image.pixel(i % kProbeSize, i / kProbeSize);
    REQUIRE((p[0] >= 0.0F && p[1] >= 0.0F && p[2] >= 0.0F));
    black += p[0] == 0.0F ? 1U : 0U;
  }
  CHECK(black > 100);
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelProbes, WallsAndNearerSpheresHideThem", "[vulkan]") {
  ProbeStage stage;
  const FloatImage without = stage.draw({});
  CHECK(stage.draw({uneven({0.0, 2.0, -4.0})}).rgba == without.rgba);  // behind the wall
  CHECK(stage.draw({uneven({0.2, 2.0, 5.0})}).rgba == without.rgba);   // behind the camera
  CHECK(stage.draw({uneven(kEye)}).rgba == without.rgba);              // around it
  const ProbeSphere near = uneven({0.2, 2.0, 0.0});
  ProbeSphere far = uneven({0.2, 2.0, -1.0});
  for (auto& direction : far.irradiance)
    for (float& channel : direction) channel = 9.0F;
  const FloatImage alone = stage.draw({near});
  CHECK(alone.rgba != without.rgba);
  CHECK(stage.draw({near, far}).rgba == alone.rgba);  // The farther one looks smaller.
  CHECK(stage.draw({far, near}).rgba == alone.rgba);
  // Most of the sphere is inside the wall, whose south face is at z = -2.9. The part outside shows.
  const ProbeSphere sunk = uneven({0.0, 2.0, -3.1});
  const FloatImage shown = stage.draw({sunk});
  std::size_t seen = 0;
  std::size_t hidden = 0;
  for (uint32_t y = 0; y < kProbeSize; ++y)
    for (uint32_t x = 0; x < kProbeSize; ++x) {
      const auto normal = meet(sunk, kEye, rayAt(kNorth, x, y)).normal;
      const double out_m = normal ? double{sunk.position[2]} + WELKIN_PROBE_RADIUS * normal->z + 2.9 : -1.0;
      if (std::abs(out_m) < 0.005) continue;
      ++(out_m > 0.0 ? seen : hidden);
      if (out_m > 0.0)
        REQUIRE(double{shown.pixel(x, y)[1]} == Approx(radianceOf(sunk, *normal).y).margin(kTolerance));
      else
        REQUIRE(std::equal(shown.pixel(x, y), shown.pixel(x, y) + 4, without.pixel(x, y)));
    }
  CHECK(seen > 100);
  CHECK(hidden > 1000);
  CHECK(stage.draw({}).rgba == without.rgba);
  CHECK(stage.device.messageCount() == 0);
}

}  // namespace welkin::tests
