// SPDX-License-Identifier: Apache-2.0
#include "baked/level_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "baked/welkin_file.h"
#include "probes/build/level_files.h"
#include "probes/geometry/sector_name.h"
#include "sky/bake/runtime_error.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::baked {
namespace {

using bake::require;

/// Irradiance at each point with some of the light's parts alone.
void lightOf(Level& level, const WelkinSkySample& sample, const std::array<float, 3>& parts,
             const std::vector<Float3>& position, const std::vector<Float3>& normal, std::vector<Float3>& irradiance,
             std::vector<std::uint8_t>& served) {
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = parts[0];
  light.sun_bounce = parts[1];
  light.local = parts[2];
  require(welkin_level_set_light(level.get(), &light), "the light of the level", welkin_argument_error());
  require(welkin_level_relight(level.get(), UINT32_MAX, nullptr), "relighting the level", welkin_argument_error());
  const auto rows = [](const std::vector<Float3>& v) { return reinterpret_cast<const float(*)[3]>(v.data()); };
  require(welkin_level_irradiance(level.get(), position.size(), rows(position), rows(normal),
                                  reinterpret_cast<float(*)[3]>(irradiance.data()), served.data()),
          "looking up the level's light", welkin_argument_error());
}

Float3 floats(const f64::Number3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}

}  // namespace

LevelFolder::LevelFolder(const std::filesystem::path& folder, std::size_t lights, const Instead& instead)
    : sky_(openSky(skyFileOf(folder.string()))) {
  const auto read = [&](const std::filesystem::path& path) {
    const auto other = instead.find(path);
    const std::vector<std::byte> bytes = other == instead.end() ? base::readFile(path) : other->second;
    Bytes file{std::vector<std::max_align_t>(bytes.size() / sizeof(std::max_align_t) + 1), bytes.size()};
    std::copy(bytes.begin(), bytes.end(), reinterpret_cast<std::byte*>(file.room.data()));
    files_.push_back(std::move(file));
  };
  const std::filesystem::path index = build::indexPath(folder);
  read(index);
  WelkinOpenInfo info{};
  info.data = files_.back().room.data();
  info.size = files_.back().size;
  WelkinLevelLimits limits{};
  limits.sector_capacity = 65535;
  limits.light_capacity = static_cast<std::uint32_t>(std::clamp(lights, std::size_t{1}, std::size_t{65536}));
  const Status opened = level_.open(info, sky_, limits);
  require(opened.code, index.string(), opened.message.c_str());
  const std::uint32_t count = level_.info().sector_count;
  files_.reserve(count + 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    WelkinSectorEntry entry;
    level_.entry(i, entry);
    const auto path = folder / "sectors" / geometry::fileNameOf({entry.x, entry.z});
    read(path);
    Sector sector;
    const Status checked = level_.openSector(files_.back().room.data(), files_.back().size, sector);
    require(checked.code, path.string(), checked.message.c_str());
    const Status added = level_.add(sector);
    require(added.code, path.string(), added.message.c_str());
  }
}

std::size_t LevelFolder::setLights(const std::vector<reference::LocalLight>& lights, const Sees& sees) {
  std::vector<WelkinPointLight> lamps;
  for (const reference::LocalLight& light : lights) {
    WelkinPointLight& lamp = lamps.emplace_back();
    for (int c = 0; c < 3; ++c) {
      lamp.position[c] = static_cast<float>(light.position[c]);
      lamp.intensity[c] = static_cast<float>(light.intensity[c]);
    }
  }
  ++light_changes_;
  WelkinLightsResult result{};
  const auto count = static_cast<std::uint32_t>(lamps.size());
  const auto number = [](const Float3& v) { return f64::Number3(double{v[0]}, double{v[1]}, double{v[2]}); };
  const auto test = [&](const Float3& from, const Float3& to) { return sees(number(from), number(to)); };
  const Status set =
      sees ? level_.setLights(lamps.data(), count, test, result) : level_.setLights(lamps.data(), count, result);
  require(set.code, "the lights of the level", set.message.c_str());
  return result.unseen;
}

std::vector<std::optional<PointLight>> LevelFolder::at(const std::vector<SurfacePoint>& points, double time_h) {
  ++light_changes_;
  WelkinSkySample sample{};
  sky_.sample(time_h, sample);
  std::vector<Float3> position, normal, total(points.size()), sky = total, sun = total, local = total;
  for (const SurfacePoint& p : points) {
    position.push_back(floats(p.position));
    normal.push_back(floats(p.normal));
  }
  std::vector<std::uint8_t> served(points.size());
  lightOf(level_, sample, {1, 0, 0}, position, normal, sky, served);
  lightOf(level_, sample, {0, 1, 0}, position, normal, sun, served);
  lightOf(level_, sample, {0, 0, 1}, position, normal, local, served);
  lightOf(level_, sample, {1, 1, 1}, position, normal, total, served);
  std::vector<std::optional<PointLight>> lights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (served[i] == 0) continue;
    lights[i] = {total[i], sky[i], sun[i], local[i]};
    // A part may fall below 0 and be kept from it. Then the others are too bright by as much.
    for (std::size_t c = 0; c < 3; ++c) {
      const float sum = sky[i][c] + sun[i][c] + local[i][c];
      const float share = sum > 0.0F ? total[i][c] / sum : 0.0F;
      for (Float3* part : {&lights[i]->sky, &lights[i]->sun_bounce, &lights[i]->local}) (*part)[c] *= share;
    }
  }
  return lights;
}

}  // namespace welkin::baked
