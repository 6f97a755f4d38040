// SPDX-License-Identifier: Apache-2.0
#include "welkin/bake_sky.h"

#include <fmt/format.h>
#include <xxhash.h>

#include <algorithm>
#include <chrono>
#include <regex>

#include "sky/atomic_file.h"
#include "sky/encode.h"
#include "sky/error.h"
#include "sky/exr.h"
#include "welkin/warnings.h"

namespace welkin::tools {
namespace {

using Json = nlohmann::ordered_json;

class Stopwatch {
 public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    return std::chrono::duration<double>(now - std::exchange(last_, now)).count();
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

std::string hashText(std::span<const std::byte> bytes) {
  const XXH128_hash_t hash = XXH3_128bits(bytes.data(), bytes.size());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

/// Writes outputs and remembers them for the report.
struct Outputs {
  std::filesystem::path folder;
  Json list = Json::array();

  void write(const std::string& name, std::span<const std::byte> bytes) {
    writeFile(folder / name, bytes);
    list.push_back({{"file", name}, {"bytes", bytes.size()}, {"xxh3_128", hashText(bytes)}});
  }
};

/// Cubemaps of an earlier bake that this one did not write.
void removeStaleCubemaps(const std::filesystem::path& folder, const std::vector<std::string>& names) {
  static const std::regex kOurs("(sky_[0-9]{9})(_latlong)?\\.exr(\\.tmp)?");
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    std::smatch match;
    const std::string name = entry.path().filename().string();
    if (std::regex_match(name, match, kOurs) &&
        (match[3].matched || std::find(names.begin(), names.end(), match[1].str()) == names.end()))
      std::filesystem::remove(entry.path(), error);
  }
}

std::vector<std::string> cubemapNames(const sky::BakeSettings& bake) {
  std::vector<std::string> names;
  for (const double time : bake.cubemap_time_h) names.push_back(cubemapName(time));
  return names;
}

}  // namespace

std::string cubemapName(double time_h) {
  const long ms = sky::millisecondOf(time_h);
  return fmt::format("sky_{:02}{:02}{:02}{:03}", ms / 3600000, ms / 60000 % 60, ms / 1000 % 60, ms % 1000);
}

Json bakeSky(const sky::SkyFile& file, const std::filesystem::path& folder, ProgressReport::Style style, Json& timing) {
  const auto names = cubemapNames(file.bake);
  makeFolder(folder);
  Outputs outputs{folder};
  Stopwatch watch;

  sky::DayTable table;
  {
    ProgressReport progress(style, "table", file.bake.key_time_h.size());
    table = sky::bakeDayTable(file.sky, file.bake.bands, file.bake.key_time_h, [&] { return progress.step(); });
  }
  timing["table_s"] = watch.lap();

  std::size_t saturated = 0;
  std::vector<sky::Cubemap> cubemaps;
  if (!names.empty()) {
    makeFolder(folder / "cubemaps");
    ProgressReport progress(style, "cubemaps", names.size());
    const sky::SkyProjector projector(file.sky.luminance, 1);
    const sky::Progress keep_going = [] { return !interrupted(); };
    for (std::size_t i = 0; i < names.size(); ++i) {
      const sky::SkyInstant instant(file.sky, file.bake.cubemap_time_h[i]);
      const auto ground = instant.groundRadiance(projector.project(instant).horizontal_irradiance);
      const auto render = [&](sky::Layout layout) {
        auto image = sky::renderDome(instant, ground, layout, file.bake.cubemap_size, keep_going);
        saturated += image.saturated;
        return image;
      };
      cubemaps.push_back(
          sky::renderCubemap(instant, ground, file.bake.cubemap_size, file.bake.cubemap_format, keep_going));
      saturated += cubemaps.back().saturated;
      for (const auto& [layout, suffix] :
           {std::pair(sky::Layout::exr_cube, ".exr"), {sky::Layout::exr_latlong, "_latlong.exr"}})
        outputs.write("cubemaps/" + names[i] + suffix,
                      sky::encodeExr(render(layout), layout, file.sky.luminance_unit, keep_going));
      if (!progress.step()) throw Error(ExitStatus::interrupted, "interrupted; finished files are kept");
    }
  }
  timing["cubemaps_s"] = watch.lap();
  outputs.write("sky.welkin", sky::encodeSky(file, table, cubemaps));
  removeStaleCubemaps(folder / "cubemaps", names);
  timing["write_s"] = watch.lap();

  Json inputs = Json::array();
  for (const auto& input : file.inputs)
    inputs.push_back(
        {{"name", input.name}, {"xxh3_128", fmt::format("{:016x}{:016x}", input.xxh3_high, input.xxh3_low)}});
  Json warnings = warningsJson(file);
  if (saturated > 0)
    warnings.push_back(
        {{"id", "half-saturated"},
         {"count", saturated},
         {"message",
          fmt::format("{} components of the cubemaps are past the largest value of their format ({}: {}; EXR: "
                      "65504) and were stored as that; raise luminance_unit and lower intensity",
                      saturated, format::nameOf(file.bake.cubemap_format),
                      format::largestOf(file.bake.cubemap_format, 2))}});
  return {{"format_version", 1},
          {"inputs", inputs},
          {"settings", Json::parse(file.settings)},
          {"table",
           {{"bands", table.bands},
            {"keys", table.key_time_h.size()},
            {"evaluations", table.evaluations},
            {"bytes", (table.shape_sh.size() + table.shape_irradiance.size()) * sizeof(float)}}},
          {"cubemaps",
           {{"size", names.empty() ? 0 : file.bake.cubemap_size},
            {"format", format::nameOf(file.bake.cubemap_format)},
            {"time_h", file.bake.cubemap_time_h}}},
          {"outputs", outputs.list},
          {"warnings", warnings}};
}

}  // namespace welkin::tools
