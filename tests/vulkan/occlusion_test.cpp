// SPDX-License-Identifier: Apache-2.0
// Occlusion in screen space: its formulas against quadrature and closed forms, its passes against closed forms, and
// its place in the level picture.
#include <random>
#include <set>

#include "compute.h"
#include "level_stage.h"
#include "occlusion_view.h"
#include "probes/geometry/directions.h"
#include "probes/loader/surfaces_of.h"
#include "spirv/kOcclusionDenoise.h"
#include "spirv/kOcclusionFine.h"
#include "spirv/kOcclusionShipped.h"

#define INLINE inline
#define CONSTANT inline constexpr
#define NUMBER(literal) Number(literal)
namespace welkin::occlusion_formulas {
using namespace f64;
#include "occlusion.glsl"  // NOLINT(bugprone-suspicious-include)
}  // namespace welkin::occlusion_formulas
#undef NUMBER
#undef CONSTANT
#undef INLINE

namespace welkin::tests {
namespace {

using occlusion_formulas::sliceArc;
using occlusion_formulas::sliceLight;

/// Mean over `slices` slices through the view direction of the light that `horizons` leaves. It gives the two cosines
/// of a slice by its tangent.
template <typename Horizons>
double meanOfSlices(const Number3& view, const Number3& normal, int slices, const Horizons& horizons) {
  double sum = 0.0;
  for (int i = 0; i < slices; ++i) {
    const double turn = f64::kPi * (i + 0.5) / slices;
    const Number3 tangent = geometry::inFrameOf(view, std::cos(turn), std::sin(turn), 0.0);
    const double along_view = dot(normal, view);
    const double along_tangent = dot(normal, tangent);
    const auto [against, along] = horizons(tangent);
    sum += std::hypot(along_view, along_tangent) * sliceLight(against, along, std::atan2(along_tangent, along_view));
  }
  return sum / slices;
}

/// A wall along z at x = 0, as high as kWallHeight, before ground that ends kGround_m before it, where it meets the
/// wall, and level ground above.
constexpr double kWallHeight = 1.5;
constexpr double kGround_m = 2.5;
constexpr double kRadius_m = 4.0;  // WELKIN_OCCLUSION_RADIUS_M

/// Visibility of a surface beside an endless strip that stands on it at a distance, `height` wide, by quadrature over
/// the azimuth: 1 - 1 / (2 pi) of the integral of sin^2 of the strip's elevation. What is farther than the radius does
/// not count. For a large radius that is (1 + cos g) / 2 with tan g = height / distance (docs/conventions.md).
double visibilityBesideStrip(double distance, double height, double radius_m = kRadius_m) {
  constexpr int kSteps = 2000;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double away = distance / std::cos(f64::kPi * ((i + 0.5) / kSteps - 0.5));
    if (away > radius_m) continue;
    const double seen = std::min(height, std::sqrt(radius_m * radius_m - away * away));
    sum += seen * seen / (away * away + seen * seen);
  }
  return 1.0 - 0.5 * sum / kSteps;
}

GltfText groundAndWall() {
  GltfText gltf;
  const int grey = gltf.addMaterial({0.5, 0.5, 0.5}, true);
  const auto rectangle = [&](std::vector<float> corners) {
    gltf.addNode(gltf.addMesh({std::move(corners), {0, 1, 2, 0, 2, 3}}, grey), nlohmann::json::object());
  };
  const auto h = static_cast<float>(kWallHeight);
  const auto g = static_cast<float>(kGround_m);
  rectangle({0, 0, -60, 0, h, -60, 0, h, 60, 0, 0, 60});
  rectangle({-g, 0, -60, -g, 0, 60, 0, 0, 60, 0, 0, -60});
  rectangle({0, h, -60, 0, h, 60, 9, h, 60, 9, h, -60});  // what is above the step
  return gltf;
}

/// Sees ground, wall and step. The wall's foot is in the middle.
const Camera kAcross{f64::kHalfPi + 0.4, -0.7, 0.9};
const Number3 kWallEye(-8.0, 7.5, -3.0);

/// Nothing within `margin` of an edge.
std::optional<double> visibilityBesideWall(const Number3& p, const Number3& normal, double margin) {
  if (p.y > kWallHeight - 1e-3) return normal.y > 0.5 ? std::optional(1.0) : std::nullopt;
  if (normal.y > 0.5) {
    const double distance = -p.x;
    if (distance < margin || distance > kGround_m - margin) return std::nullopt;
    return visibilityBesideStrip(distance, kWallHeight);
  }
  if (p.y < margin || p.y > kWallHeight - margin) return std::nullopt;
  return visibilityBesideStrip(p.y, kGround_m);
}

struct OcclusionErrors {
  double mean = 0.0, rms = 0.0, worst = 0.0;
  std::size_t count = 0;
};

OcclusionErrors errorsOf(const std::vector<float>& values, const OcclusionView& view) {
  OcclusionErrors e;
  for (const auto& [pixel, hit] : view.seen) {
    const auto expected = visibilityBesideWall(hit.position, hit.normal, 0.1);
    const auto x = static_cast<uint32_t>(pixel % view.width);
    const auto y = static_cast<uint32_t>(pixel / view.width);
    constexpr uint32_t kRim = 140;  // nearer to the picture's edge something within the radius is out of sight
    if (!expected || x < kRim || y < kRim || x + kRim >= view.width || y + kRim >= view.height) continue;
    const double off = double{values[pixel]} - *expected;
    e.mean += off;
    e.rms += off * off;
    e.worst = std::max(e.worst, std::abs(off));
    ++e.count;
  }
  e.mean /= static_cast<double>(e.count);
  e.rms = std::sqrt(e.rms / static_cast<double>(e.count));
  return e;
}

}  // namespace

TEST_CASE("Occlusion, SliceArcIsItsIntegral") {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double gamma = f64::kHalfPi * unit(random);
    const double h = gamma + f64::kHalfPi * unit(random);
    constexpr int kSteps = 2000;  // midpoints of h / 2000: off by less than h^3 / 24 / 2000^2 = 8e-8
    double sum = 0.0;
    for (int k = 0; k < kSteps; ++k) {
      const double at = h * (k + 0.5) / kSteps;
      sum += std::cos(at - gamma) * std::abs(std::sin(at)) * std::abs(h) / kSteps;
    }
    CHECK(sliceArc(h, gamma) == Approx(sum).margin(4e-7));
    CHECK(sliceLight(-1.0, -1.0, gamma) == Approx(std::cos(gamma) + gamma * std::sin(gamma)).epsilon(1e-12));
  }
}

TEST_CASE("Occlusion, SlicesAddUpToTheHemisphere") {
  const auto open = [](const Number3&) { return std::pair(-1.0, -1.0); };
  for (const double tilt : {0.0, 0.3, 0.9, 1.3, 1.55}) {
    const Number3 normal = geometry::unit({0.2, 1.0, -0.4});
    const Number3 view = geometry::inFrameOf(normal, 0.6 * std::sin(tilt), 0.8 * std::sin(tilt), std::cos(tilt));
    CHECK(meanOfSlices(view, normal, 2000, open) == Approx(1.0).epsilon(1e-6));
    // An endless wall to an elevation: what is under a plane through the point is blocked.
    for (const double elevation : {0.2, 0.8, 1.3}) {
      const Number3 below = geometry::inFrameOf(normal, std::sin(elevation), 0.0, -std::cos(elevation));
      if (dot(view, below) > -0.01) continue;  // the view starts in the wall
      const auto horizons = [&](const Number3& tangent) {
        // cos h (view . below) + sin h (tangent . below) = 0
        const double a = dot(view, below);
        const double b = dot(tangent, below);
        const double cosine = b / std::hypot(a, b);
        return std::pair(-cosine, cosine);
      };
      INFO("tilt " << tilt << ", elevation " << elevation);
      CHECK(meanOfSlices(view, normal, 20000, horizons) == Approx(0.5 + 0.5 * std::cos(elevation)).margin(1e-5));
    }
  }
}

TEST_CASE("Occlusion, AnyFourByFourPixelsHaveEveryTurnOnce") {
  for (const int corner : {0, 1, 2, 3, 1917}) {
    std::set<double> turns;
    std::multiset<double> offsets;
    for (int i = 0; i < 16; ++i) {
      turns.insert(occlusion_formulas::sliceTurn(corner + i % 4, 2 * corner + i / 4));
      offsets.insert(occlusion_formulas::stepOffset(corner + i % 4, 2 * corner + i / 4));
    }
    CHECK(turns.size() == 16);
    CHECK(*turns.begin() == 0.0);
    CHECK(*turns.rbegin() == 15.0 / 16.0);
    for (const double offset : {0.125, 0.375, 0.625, 0.875}) CHECK(offsets.count(offset) == 4);
  }
}

// Many slices and steps leave the error of the pixels, which are 3 cm wide: 2 % of the wall. Few steps miss the wall's
// upper edge, so that the shipped settings leave too much light. Denoising adds a blur over the 5 cm at the wall's
// foot.
TEST_CASE("Occlusion, GroundBesideAWallHasItsClosedForm", "[vulkan]") {
  CHECK(visibilityBesideStrip(1.0, 2.0, 1e6) == Approx(0.5 + 0.5 * std::cos(std::atan2(2.0, 1.0))).epsilon(1e-6));
  const geometry::Surfaces surfaces = loader::surfacesOf(sceneOf(groundAndWall()), 1.0);
  const geometry::Tracer tracer(surfaces);
  OcclusionView view = occlusionView(tracer, kAcross, kWallEye, 480, 360);
  render::VulkanDevice device(true);
  const auto run = [&](std::span<const uint32_t> pass) {
    return runCompute(device, pass, view.buffer, view.pixels(), 1, VK_NULL_HANDLE, VK_NULL_HANDLE);
  };
  const auto check = [&](const char* name, const std::vector<float>& values, double mean, double rms, double worst) {
    const OcclusionErrors e = errorsOf(values, view);
    WARN(name << ": mean " << e.mean << ", rms " << e.rms << ", worst " << e.worst << " of " << e.count << " pixels");
    CHECK(e.count > 5000);
    CHECK(std::abs(e.mean) < mean);
    CHECK(e.rms < rms);
    CHECK(e.worst < worst);
  };
  check("8 slices, 32 steps", run(kOcclusionFine), 0.01, 0.015, 0.03);
  const std::vector<float> found = run(kOcclusionShipped);
  check("shipped", found, 0.04, 0.05, 0.15);
  view.setFound(found);
  check("shipped, denoised", run(kOcclusionDenoise), 0.04, 0.04, 0.1);
  CHECK(device.messageCount() == 0);
}

TEST_CASE("Occlusion, OpenGroundIsExactlyFree", "[vulkan]") {
  GltfText gltf;
  gltf.addNode(gltf.addMesh(squareMesh(), gltf.addMaterial({0.5, 0.5, 0.5})),
               {{"scale", {60, 1, 60}}, {"rotation", {0.1, 0, 0.05, std::sqrt(1.0 - 0.0125)}}});
  Stage stage(sceneOf(gltf));
  stage.view->setTime(12.0);
  for (const double pitch : {-1.5, -0.6, -0.2, 0.0})
    for (const double height : {0.8, 2.0, 15.0}) {
      const FloatImage image = stage.view->drawOcclusion(192, 108, {0.7, pitch, 1.2}, {1.0, height, -2.0});
      std::size_t seen = 0;
      std::size_t off = 0;
      for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
        if (image.rgba[i + 3] == 0.0F) continue;
        ++seen;
        if (image.rgba[i] != 1.0F) ++off;
      }
      INFO("pitch " << pitch << ", height " << height);
      CHECK(seen > 500);
      CHECK(off == 0);
    }
  CHECK(stage.device.messageCount() == 0);
}

TEST_CASE("LevelView, OcclusionDarkensAmbientLightAlone", "[vulkan]") {
  const auto scene = [] {
    GltfText gltf = groundAndWall();
    gltf.json["materials"][0]["emissiveFactor"] = {0.25, 0.5, 0.125};
    gltf.addPointLight({-1, 1, 0});
    return sceneOf(gltf);
  };
  Stage stage(scene());
  REQUIRE(stage.scene.lights.size() == 1);
  render::LevelOptions options = kPlain;
  options.occlusion = true;
  render::LevelView occluded(stage.device, stage.sky, stage.scene, options);
  for (const double time_h : {12.3, 19.0}) {
    stage.view->setTime(time_h);
    occluded.setTime(time_h);
    const FloatImage without = stage.view->draw(160, 120, kAcross, kWallEye);
    const FloatImage with = occluded.draw(160, 120, kAcross, kWallEye);
    const FloatImage alone = stage.view->drawOcclusion(160, 120, kAcross, kWallEye);
    double darkest = 1.0;
    double most = 0.0;  // hidden light as a share of all
    Worst worst;
    forEachPixel(with, kAcross, [&](const Pixel& pixel) {
      const float* const visibility = alone.pixel(pixel.x, pixel.y);
      if (visibility[3] == 0.0F) return;
      darkest = std::min(darkest, double{visibility[0]});
      // Which of the three rectangles the ray meets first.
      const Number3& ray = pixel.ray;
      const double to_wall = -kWallEye.x / ray.x;
      const double wall_y = kWallEye.y + ray.y * to_wall;
      const bool wall = ray.x > 0.0 && wall_y > 0.0 && wall_y < kWallHeight;
      const Number3 normal = wall ? Number3(-1.0, 0.0, 0.0) : Number3(0.0, 1.0, 0.0);
      const Number3 ambient = skyIrradiance(stage.sky, stage.view->sample(), normal);
      const double hidden = 1.0 - double{visibility[0]};
      for (int i = 0; i < 3; ++i) {
        const double light = 0.5 / f64::kPi * ambient[i] * hidden;
        const double full = double{without.pixel(pixel.x, pixel.y)[i]};
        most = std::max(most, light / full);
        worst.compare(double{with.pixel(pixel.x, pixel.y)[i]}, full - light, full,
                      [&] { return "pixel " + std::to_string(pixel.x) + "," + std::to_string(pixel.y); });
      }
    });
    // The light pass reads the visibility in 8 bits, which a device may truncate: up to 1/255 of the ambient light.
    WARN("hour " << time_h << ": worst " << worst.error << " at " << worst.where << ", least visibility " << darkest
                 << ", most hidden light " << most);
    CHECK(most > 0.1);
    CHECK(darkest < 0.7);
    CHECK(worst.error < kSurfaceTolerance + 1.0 / 255.0);
  }
  CHECK(stage.device.messageCount() == 0);
}

}  // namespace welkin::tests
