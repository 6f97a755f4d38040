// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the text of a sky.toml. An accepted sky can be evaluated, baked and opened at any hour.
#include <welkin/welkin.h>

#include <algorithm>
#include <array>

#include "format/key_segment.h"
#include "fuzz.h"
#include "sky/bake/encode.h"
#include "sky/bake/sky_file.h"
#include "sky/image/image_module.h"
#include "sky/table/day_table.h"

namespace welkin::fuzz {
namespace {

using det::Number3;

constexpr double kHours[] = {0.0, 5.9, 12.0, 18.3, 23.999};

/// The images that an input may name: "sun.ppm", "anti.ppm" and "stars.ppm".
const Folder& folder() {
  static const Folder kFolder;
  [[maybe_unused]] static const bool kWritten = [] {
    constexpr std::string_view kImages[][2] = {
        {"sun.ppm", "P3 3 2 255  9 20 90 200 220 255 8 9 40  0 9 9 255 180 99 9 9 9"},
        {"anti.ppm", "P3 1 3 255  40 60 120  60 70 90  0 0 0"},
        {"stars.ppm", "P3 2 1 255  0 0 0  255 255 255"}};
    for (const auto& [name, text] : kImages)
      kFolder.write(std::string(name), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    image::imageModule();  // loaded before the time of an input counts
    return true;
  }();
  return kFolder;
}

void checkBake(const bake::BakeSettings& bake) {
  require(bake.bands >= 2 && bake.bands <= 5, "bands are 2 to 5");
  require(format::areKeyTimes(bake.key_time_h) && bake.key_time_h.size() <= 86400, "keys are at most 86400 key times");
  require(bake.cubemap_size == 0 || (bake.cubemap_size >= 2 && bake.cubemap_size <= 4096),
          "cubemap_size is 0 or 2 to 4096");
  require(bake.cubemap_size == 0 ? bake.cubemap_time_h.empty()
                                 : format::areKeyTimes(bake.cubemap_time_h) && bake.cubemap_time_h.size() <= 1440,
          "cubemap_times are at most 1440 key times, and none without a size");
}

void checkInstant(const model::Sky& sky, double time_h) {
  const model::SkyInstant instant(sky, time_h);
  const Number3 sun = instant.sunDirection();
  require(isFinite(sun) && std::abs(dot(sun, sun) - 1.0) < 1e-9, "the sun's direction is of length 1");
  require(std::isfinite(instant.luminanceNorm()) && instant.luminanceNorm() > 0.0,
          "the normalising luminance is positive");
  require(std::isfinite(instant.intensity()) && instant.intensity() >= 0.0, "the intensity is not negative");
  const Number3 ground = instant.groundRadiance(Number3(1.0));
  require(isFinite(ground), "the ground's radiance is finite");
  for (const Number3& direction : {Number3(0.0, 1.0, 0.0), Number3(1.0, 0.0, 0.0), Number3(0.0, 0.6, -0.8),
                                   Number3(0.0, -1.0, 0.0), Number3(sun.x, std::abs(sun.y), sun.z)})
    require(isFinite(instant.dome(direction, ground)), "the dome's radiance is finite");
}

/// Bakes one key and opens the result like a game.
void checkBaked(const bake::SkyFile& file) {
  constexpr int kBands = 2;
  const auto table = table::bakeDayTable(file.sky, kBands, {kHours[2]}, {});
  const auto finite = [](auto v) { return std::isfinite(v); };
  require(std::all_of(table.number.begin(), table.number.end(), finite), "the table's numbers are finite");
  const auto bytes = bake::encodeSky(file, table, {});
  WelkinSky* opened = nullptr;
  WelkinMessage message{};
  const WelkinResult result = welkin_sky_open_memory(bytes.data(), bytes.size(), &opened, &message);
  require(result == WELKIN_OK, std::string("the runtime opens what was baked: ") + message.text);
  for (const double time_h : kHours) {
    WelkinSkySample sample{};
    require(welkin_sky_sample(opened, time_h, &sample) == WELKIN_OK, "the runtime samples what was baked");
    for (const auto& coefficient : sample.ambient_sh)
      require(std::all_of(std::begin(coefficient), std::end(coefficient), finite), "the samples are finite");
  }
  welkin_sky_close(opened);
}

}  // namespace
}  // namespace welkin::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  const auto path = fuzz::folder().write("sky.toml", {bytes, size});
  bake::SkyFile file;
  if (!fuzz::accepts([&] { file = bake::readSkyFile(path); })) return 0;
  fuzz::require(!file.inputs.empty() && !file.settings.empty(), "inputs and settings are recorded");
  fuzz::checkBake(file.bake);
  for (const double time_h : fuzz::kHours) fuzz::checkInstant(file.sky, time_h);
  fuzz::checkBaked(file);
  return 0;
}
