// SPDX-License-Identifier: Apache-2.0
// Charts that determine no calibration end in an error that tells why, and are the same error for any threads.
#include <tbb/global_control.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "calibrate/photo.h"
#include "sh/deterministic.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "synthetic_chart.h"
#include "tests/folder.h"

using namespace welkin;
using namespace welkin::calibrate;
using tests::laterChart;
using Change = void (*)(float* texel);

namespace {

/// Half as large as usual, for the time of the search.
tests::Scene smallScene() {
  tests::Scene scene;
  scene.width /= 2;
  scene.height /= 2;
  for (Point& p : scene.corners) p *= 0.5;
  return scene;
}

image::Image leaky(const ReferenceChart& reference, Change change) {
  tests::Camera camera;
  camera.matrix = tests::leakyMatrix();
  image::Image image = photograph(reference, smallScene(), camera);
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) change(image.rgb.data() + i);
  return image;
}

/// The message without the file's name; empty if the photograph was calibrated.
std::string whyNoAlbedo(const image::Image& image, bool by_hand, std::size_t threads) {
  const tests::Folder folder;
  std::vector<std::uint8_t> code;
  for (const float v : image.rgb)
    code.push_back(static_cast<std::uint8_t>(std::lround(255.0 * det::srgbEncode(double{v}))));
  const std::filesystem::path path = folder / "photo.png";
  base::writeFile(path, image::encodePng(image.width, image.height, code));
  PhotoOptions options;
  options.reference = laterChart();
  if (by_hand) options.corners = smallScene().corners;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
  try {
    calibratePhoto(path, options);
  } catch (const base::Error& e) {
    CHECK(e.status() == base::ExitStatus::content);
    const std::string what = e.what();
    REQUIRE(what.starts_with(path.string() + ": "));
    return what.substr(path.string().size() + 2);
  }
  return "";
}

struct Case {
  const char* name;
  image::Image image;
  const char* reason;  ///< part of the message about a chart whose corners are given
};

std::vector<Case> degenerateCharts() {
  ReferenceChart same, two;
  same.fill(Colour(0.3, 0.2, 0.1));
  for (std::size_t i = 0; i < kPatches; ++i) two[i] = i % 5 == 0 ? Colour(0.1, 0.4, 0.2) : Colour(0.5, 0.2, 0.3);
  const Change none = [](float*) {};
  return {
      {"equal patches", leaky(same, none), "its patches do not differ in colour"},
      {"two colours", leaky(two, none), "its patches do not differ in colour"},
      {"no red", leaky(laterChart(), [](float* c) { c[0] = 0.0F; }), "its channel r has no light"},
      {"no green", leaky(laterChart(), [](float* c) { c[1] = 0.0F; }), "its channel g has no light"},
      {"no blue", leaky(laterChart(), [](float* c) { c[2] = 0.0F; }), "its channel b has no light"},
      {"red does not vary", leaky(laterChart(), [](float* c) { c[0] = 0.25F; }), "its patches do not differ in colour"},
      {"black", leaky(laterChart(), [](float* c) { std::fill(c, c + 3, 0.0F); }), "its channel r has no light"},
      {"white", leaky(laterChart(), [](float* c) { std::fill(c, c + 3, 1.0F); }),
       "24 of its 24 patches are overexposed"},
      {"clipped",
       leaky(laterChart(),
             [](float* c) { std::transform(c, c + 3, c, [](float v) { return std::min(1.0F, 20.0F * v); }); }),
       "of its 24 patches are overexposed"},
      {"one channel clipped", leaky(laterChart(), [](float* c) { c[2] = 1.0F; }),
       "24 of its 24 patches are overexposed"},
  };
}

}  // namespace

TEST_CASE("Degenerate, APhotographIsRefusedWithItsReasonForAnyThreads") {
  for (const Case& chart : degenerateCharts()) {
    INFO(chart.name);
    const std::string why = whyNoAlbedo(chart.image, true, 1);
    INFO(why);
    CHECK(why.starts_with("the chart at --corners: "));
    CHECK(why.find(chart.reason) != std::string::npos);
    CHECK(why == whyNoAlbedo(chart.image, true, 4));
    const std::string searched = whyNoAlbedo(chart.image, false, 4);
    INFO(searched);
    CHECK((searched.starts_with("no ColorChecker Classic was found") || searched.starts_with("no chart to trust: ")));
  }
}

TEST_CASE("Degenerate, PatchesDetermineNoModelOfAnyKind") {
  const auto why = [](const Patches& patches, std::string_view model) -> std::string {
    try {
      calibratePatches("photo", patches, laterChart(), model);
    } catch (const base::Error& e) {
      CHECK(e.status() == base::ExitStatus::content);
      return e.what();
    }
    return "";
  };
  const Patches good = tests::seenPatches(laterChart(), {});
  std::vector<std::string> names = {"auto"};
  for (const ModelKind& kind : models()) names.emplace_back(kind.name);
  for (const std::string& name : names) {
    INFO(name);
    CHECK(why(good, name) == "");
    Patches same = good, dead = good, clipped = good;
    for (Patch& p : same) p.mean = Colour(0.3, 0.2, 0.1);
    for (Patch& p : dead) p.mean[1] = 0.0;
    for (std::size_t i = 0; i < 7; ++i) clipped[i].clipped = 1.0;
    CHECK(why(same, name) == "photo: the chart's patches do not differ in colour: they determine no calibration");
    CHECK(why(dead, name) == "photo: the chart has no light in green: every patch is 0 there");
    CHECK(why(clipped, name) ==
          "photo: 7 of 24 patches are overexposed and 0 are partly in shadow or covered; at least 18 good ones are "
          "needed");
  }
}
