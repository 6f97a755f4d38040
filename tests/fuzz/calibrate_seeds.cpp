// SPDX-License-Identifier: Apache-2.0
// Writes the seeds of calibrate_fuzz.cpp into a folder: small photographs of a chart, good ones and spoilt ones.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "calibrate/tiff.h"
#include "sh/deterministic.h"
#include "sky/base/atomic_file.h"
#include "tests/calibrate/synthetic_chart.h"

using namespace welkin;

namespace {

constexpr int kWidth = 128, kHeight = 96;

/// A chart over the middle of the picture, as all photographs here have it.
image::Image chartThrough(const tests::Camera& camera) {
  tests::Scene scene;
  scene.width = kWidth;
  scene.height = kHeight;
  scene.corners = {calibrate::Point(24, 20), calibrate::Point(104, 20), calibrate::Point(104, 74),
                   calibrate::Point(24, 74)};
  return photograph(calibrate::referenceChart(calibrate::Edition::after_2014), scene, camera);
}

template <typename Code>
std::vector<Code> codesOf(const image::Image& image, double full) {
  std::vector<Code> codes;
  for (const float v : image.rgb) codes.push_back(static_cast<Code>(std::lround(full * det::srgbEncode(double{v}))));
  return codes;
}

/// In one more byte than the picture needs where that gives the size the parity, on which the options depend.
void write(const std::filesystem::path& path, std::vector<std::byte> bytes, bool odd) {
  if (bytes.size() % 2 != (odd ? 1U : 0U)) bytes.push_back(std::byte{0});
  base::writeFile(path, bytes);
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("usage: calibrate_seeds FOLDER\n", stderr);
    return 1;
  }
  const std::filesystem::path folder = arguments[1];
  base::makeFolder(folder);
  tests::Camera camera;
  camera.matrix = tests::leakyMatrix();
  const image::Image good = chartThrough(camera);
  image::Image dead = good, clipped = good;
  for (std::size_t i = 1; i < dead.rgb.size(); i += 3) dead.rgb[i] = 0.0F;
  for (float& v : clipped.rgb) v = std::min(1.0F, 8.0F * v);
  for (const bool odd : {false, true}) {
    const std::string of = odd ? "by_hand" : "searched";
    const auto png = [](const image::Image& image) {
      return image::encodePng(image.width, image.height, codesOf<std::uint8_t>(image, 255.0));
    };
    write(folder / ("chart_" + of + ".png"), png(good), odd);
    write(folder / ("dead_" + of + ".png"), png(dead), odd);
    write(folder / ("clipped_" + of + ".png"), png(clipped), odd);
    write(folder / ("chart_" + of + ".tif"),
          calibrate::encodeTiff(kWidth, kHeight, codesOf<std::uint16_t>(good, 65535.0)), odd);
  }
  return 0;
}
