// SPDX-License-Identifier: Apache-2.0
// The path tracer's light in the level picture: places of surfaces, an irradiance from elsewhere, and its error.
#include "render/level_reference.h"

#include <catch2/catch.hpp>
#include <cmath>

#include "level_stage.h"
#include "probes/loader/surfaces_of.h"
#include "render/difference.h"
#include "tests/probes/skies.h"

namespace welkin::tests {
namespace {

constexpr uint32_t kTracedSize = 64;
const Camera kTracedCamera{0.3, -0.5, 1.0};
const Number3 kTracedFrom(1.0, 4.0, 9.0);
constexpr double kDepthTolerance_m = 2e-5;  // of a depth in 32-bit float at some 20 m, and the ray's float matrix

/// Ground of 200 x 200 m at y = 0, and a box on it.
Scene groundWithBox() {
  GltfText gltf;
  const int grey = gltf.addMaterial({0.5, 0.5, 0.5});
  gltf.addNode(gltf.addMesh(squareMesh(), grey), {{"scale", {100, 1, 100}}});
  gltf.addNode(gltf.addMesh(boxMesh(), grey), {{"translation", {0, 1, 0}}});
  return sceneOf(gltf);
}

render::TracedImage tracedOf(const FloatImage& places, const geometry::Tracer& tracer, const model::Sky& sky,
                             const render::TraceSettings& settings) {
  const reference::DistantLight distant(sky, 12.0);
  return render::traceSurfaces(reference::pathScene(tracer, distant, {}, 2), places, kTracedCamera, kTracedFrom,
                               settings, {});
}

}  // namespace

TEST_CASE("LevelReference, PlacesLieOnTheirSurfaces") {
  Stage stage(groundWithBox());
  stage.view->setTime(12.0);
  const FloatImage places = stage.view->drawPlaces(kTracedSize, kTracedSize, kTracedCamera, kTracedFrom);
  int on_ground = 0;
  int on_box = 0;
  const auto m = render::inverseViewProjection(kTracedCamera, 1.0);
  forEachPixel(places, kTracedCamera, [&](const Pixel& p) {
    const float* place = places.pixel(p.x, p.y);
    if (place[3] == 0.0F) return;
    Number3 ray;
    for (int i = 0; i < 3; ++i) {
      const auto at = static_cast<std::size_t>(i);
      ray[i] = (2.0 * (p.x + 0.5) / kTracedSize - 1.0) * double{m[at]} +
               (2.0 * (p.y + 0.5) / kTracedSize - 1.0) * double{m[4 + at]} + double{m[12 + at]};
    }
    const Number3 at = kTracedFrom + ray * double{place[3]};
    const bool ground = std::abs(at.y) < kDepthTolerance_m * double{place[3]};
    const double out = std::max({std::abs(at.x), std::abs(at.y - 1.0), std::abs(at.z)});
    CHECK((ground || std::abs(out - 1.0) < kDepthTolerance_m * double{place[3]}));
    if (ground) CHECK(place[1] == Approx(1.0).epsilon(kSurfaceTolerance));
    (ground ? on_ground : on_box) += 1;
  });
  CHECK(on_ground > 500);
  CHECK(on_box > 50);
}

TEST_CASE("LevelReference, LightFromElsewhereReplacesThePicturesOwn") {
  Stage stage(groundWithBox());
  stage.view->setTime(12.0);
  const FloatImage own = stage.view->draw(kTracedSize, kTracedSize, kTracedCamera, kTracedFrom);
  FloatImage given = stage.view->drawPlaces(kTracedSize, kTracedSize, kTracedCamera, kTracedFrom);
  for (std::size_t i = 0; i < given.rgba.size(); i += 4) {
    const bool half = i < given.rgba.size() / 2;  // the upper half of the picture alone
    const float surface = given.rgba[i + 3] > 0.0F && half ? 1.0F : 0.0F;
    for (std::size_t c = 0; c < 3; ++c) given.rgba[i + c] = surface * (1.0F + static_cast<float>(c));
    given.rgba[i + 3] = surface;
  }
  const FloatImage lit = stage.view->draw(kTracedSize, kTracedSize, kTracedCamera, kTracedFrom, &given);
  int replaced = 0;
  for (std::size_t i = 0; i < given.rgba.size(); ++i) {
    if (given.rgba[i - i % 4 + 3] == 0.0F) {
      CHECK(lit.rgba[i] == own.rgba[i]);
    } else if (i % 4 < 3) {
      CHECK(double{lit.rgba[i]} == Approx(0.5 / f64::kPi * double{given.rgba[i]}).epsilon(kSurfaceTolerance));
      ++replaced;
    }
  }
  CHECK(replaced > 500);
}

TEST_CASE("LevelReference, OpenGroundUnderAnEvenSkyHasPi") {
  Stage stage(groundWithBox());
  stage.view->setTime(12.0);
  const FloatImage places = stage.view->drawPlaces(kTracedSize, kTracedSize, kTracedCamera, kTracedFrom);
  const geometry::Surfaces surfaces = loader::surfacesOf(stage.scene, 1.0);
  const geometry::Tracer tracer(surfaces, kTracedFrom);
  const model::Sky sky = uniformSky(1.0);
  const render::TracedImage traced = tracedOf(places, tracer, sky, {.paths = 32});
  CHECK(traced.paths == 32);
  CHECK(tracedOf(places, tracer, sky, {.paths = 33}).paths == 72);
  double furthest = 0.0;
  for (uint32_t y = 0; y < kTracedSize; ++y)
    for (uint32_t x = 0; x < kTracedSize; ++x) {
      const float* e = traced.irradiance.pixel(x, y);
      REQUIRE((e[3] == 1.0F) == (places.pixel(x, y)[3] > 0.0F));
      const bool far_ground = places.pixel(x, y)[3] > 40.0F;  // the box is at most 1e-3 of the hemisphere there
      if (far_ground) furthest = std::max(furthest, std::abs(double{e[0]} - f64::kPi));
      CHECK(e[0] <= static_cast<float>(f64::kPi) * 1.0001F);
    }
  CHECK(furthest < f64::kPi / 4.0);  // at most one of the 4 paths of a half meets the box
  const render::TracedImage none =
      tracedOf(places, tracer, sky, {.paths = 32, .parts = {0.0F, 1.0F, 1.0F}, .direct = false});
  for (std::size_t i = 0; i < none.irradiance.rgba.size(); ++i)
    if (i % 4 < 3) REQUIRE(none.irradiance.rgba[i] == 0.0F);
}

TEST_CASE("LevelReference, ErrorsAreMeansOverPixels") {
  constexpr uint32_t kWide = 240;
  FloatImage drawn{kWide, 2, std::vector<float>(std::size_t{8} * kWide, 1.0F)};
  render::TracedImage traced{drawn, std::vector<float>(std::size_t{2} * kWide, 0.0F), 8};
  for (std::size_t i = 0; i < drawn.rgba.size(); i += 4) {
    const std::size_t pixel = i / 4 % kWide / 2;  // 120 pixels of 2 x 2 samples
    const float more = pixel < 50 ? 0.5F : pixel < 70 ? -1.0F : 0.0F;
    for (std::size_t c = 0; c < 3; ++c) traced.irradiance.rgba[i + c] = 2.0F, drawn.rgba[i + c] = 2.0F + more;
    if (pixel >= 100) traced.irradiance.rgba[i + 3] = 0.0F;  // nothing is there
  }
  const render::IrradianceError error = render::errorOf(drawn, traced, 2);
  constexpr double kFloatLuminance = 1e-6;  // of luminance in float
  CHECK(error.pixels == 100);
  CHECK(error.unit == Approx(2.0).epsilon(kFloatLuminance));
  CHECK(error.mean == Approx(0.05 / 2.0).epsilon(kFloatLuminance));
  CHECK(error.rms == Approx(std::sqrt((50 * 0.25 + 20 * 1.0) / 100) / 2.0).epsilon(kFloatLuminance));
  CHECK(error.worst == Approx(-0.5).epsilon(kFloatLuminance));
  CHECK(error.noise == 0.0);
  CHECK(render::errorText(error) == "rms 28.5 %, mean +2.5 %, worst -50 %");

  const render::Picture picture = render::differencePicture(drawn, traced, 2, error);
  REQUIRE(picture.width == kWide / 2);
  const auto red = [&](std::size_t x) { return picture.rgb[3 * x]; };
  const auto blue = [&](std::size_t x) { return picture.rgb[3 * x + 2]; };
  CHECK(red(0) > blue(0));    // too bright
  CHECK(red(60) < blue(60));  // too dark
  CHECK(red(80) == blue(80));
  CHECK(red(80) > 200);
  CHECK(red(110) == 40);  // not traced

  // The tracer's own noise is taken out of the rms.
  std::fill(traced.error.begin(), traced.error.end(), 1.0F);
  const render::IrradianceError noisy = render::errorOf(drawn, traced, 2);
  CHECK(noisy.noise == Approx(0.5 / 2.0).epsilon(kFloatLuminance));  // of the mean of four samples
  CHECK(noisy.rms == Approx(std::sqrt(0.325 - 0.25) / 2.0).epsilon(kFloatLuminance));
  const render::IrradianceError black =
      render::errorOf(drawn, {FloatImage{kWide, 2, std::vector<float>(8 * kWide)}, traced.error, 8}, 2);
  CHECK((black.rms == 0.0 && black.pixels == 0));
}

}  // namespace welkin::tests
