// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/random_level.h"

#include <algorithm>
#include <cstring>
#include <numeric>
#include <random>
#include <stdexcept>

#include "sky/bake/encode.h"

namespace welkin::tests {
namespace {

using geometry::kCells;

template <typename T>
std::vector<T> randoms(std::size_t count, int low, int high, std::mt19937& random) {
  std::vector<T> values(count);
  for (T& v : values) v = static_cast<T>(std::uniform_int_distribution<int>(low, high)(random));
  return values;
}

transfer::EncodedProbes randomProbes(std::size_t n, std::size_t modes, bool emits, std::mt19937& random) {
  transfer::EncodedProbes p;
  p.low_y = 0.0F;
  p.high_y = 20.0F;
  p.position = randoms<std::uint16_t>(3 * n, 0, 65535, random);
  p.visibility = randoms<std::uint16_t>(3 * n, 0, 65535, random);
  p.sky_scale = randoms<std::uint16_t>(n, 0x3d00, 0x3f00, random);
  p.sky = randoms<std::uint8_t>(24 * n, 0, 255, random);
  p.sky_side = randoms<std::int8_t>(24 * n, -127, 127, random);
  if (modes > 0) {
    p.sun_scale = randoms<std::uint16_t>(n, 0x3d00, 0x3f00, random);
    p.sun = randoms<std::int8_t>(4 * modes * n, -127, 127, random);
    p.sun_time_h = {6.0F, 9.5F, 12.0F, 18.25F};
    p.moon_time_h = {0.5F, 3.0F, 20.0F};
    p.coefficient_scale.assign(modes, 0.7F);
    for (std::size_t m = 0; m < modes; ++m) p.mode_scale.push_back(1.0F / static_cast<float>(m + 1));
    p.mode = randoms<std::int8_t>(modes * 7 * 3, -127, 127, random);
  }
  if (emits) {
    p.emitted_scale = randoms<std::uint16_t>(n, 0x3d00, 0x3f00, random);
    p.emitted = randoms<std::uint8_t>(12 * n, 0, 255, random);
  }
  return p;
}

/// Random transfers of some of the lights to each probe.
transfer::EncodedLocal randomLocal(const std::vector<f64::Number3>& lights, const f64::Number3& corner,
                                   std::size_t probes, std::size_t transfers, std::mt19937& random) {
  transfer::EncodedLocal local;
  for (const f64::Number3& light : lights)
    for (int axis = 0; axis < 3; ++axis) local.position.push_back(static_cast<float>(light[axis] - corner[axis]));
  std::vector<std::uint16_t> all(lights.size());
  std::iota(all.begin(), all.end(), std::uint16_t{0});
  for (std::size_t p = 0; p < probes; ++p) {
    std::shuffle(all.begin(), all.end(), random);
    const std::size_t count = std::min(random() % (transfers + 1), all.size());
    local.count.push_back(static_cast<std::uint8_t>(count));
    local.light.insert(local.light.end(), all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
    std::sort(local.light.end() - static_cast<std::ptrdiff_t>(count), local.light.end());
  }
  local.scale = randoms<std::uint16_t>(local.light.size(), 0x3d00, 0x3f00, random);
  local.radiance = randoms<std::int8_t>(12 * local.light.size(), -127, 127, random);
  for (std::size_t i = 0; i < local.radiance.size(); ++i)
    if (i % 12 < 3) local.radiance[i] = static_cast<std::int8_t>(std::abs(local.radiance[i]));
  return local;
}

void demand(WelkinResult result, const char* why) {
  if (result != WELKIN_OK) throw std::runtime_error(why);
}

}  // namespace

AlignedBytes::AlignedBytes(std::span<const std::byte> bytes)
    : room(bytes.size() / sizeof(std::max_align_t) + 1), size(bytes.size()) {
  std::memcpy(static_cast<void*>(room.data()), bytes.data(), bytes.size());
}

bake::SkyFile skyOfLevel() {
  bake::SkyFile file;
  file.sky.ground_albedo = model::Number3(0.3, 0.2, 0.1);
  file.sky.sun.path.latitude_rad = 0.6;
  file.sky.sun.path.declination_rad = 0.2;
  file.sky.sun.illuminance = base::Curve::constant(5.0);
  file.sky.sun.colour = base::Curve::constant(model::Number3(1.0, 0.8, 0.6));
  file.sky.moon = file.sky.sun;
  file.sky.moon->path.transit_h = 3.0;  // for some hours both are up
  file.settings = "{}";
  file.bake.key_time_h = {0.0, 6.0, 12.0, 18.0};
  return file;
}

RandomLevel::RandomLevel(int count, std::size_t probes, std::size_t modes, transfer::SunTransfer sun, bool emits,
                         unsigned seed) {
  std::mt19937 random(seed);
  const bake::SkyFile file = skyOfLevel();
  sky = bake::encodeSky(file, table::bakeDayTable(file.sky, 3, file.bake.key_time_h, {}), {});
  for (int i = 0; i < count; ++i) {
    sectors::SectorFile s;
    s.id = {i - 1, 0};
    s.low_y = -3.0 + i % 4;
    s.cell_height_m = 4.0 + 0.5 * (i % 2);
    s.sun = sun;
    s.probes = randomProbes(probes, modes, emits, random);
    for (auto& cell : s.grid) cell = static_cast<std::uint8_t>(random() % 8 == 0 ? 255 : random() % probes);
    for (auto& cell : s.top) cell = static_cast<std::uint8_t>(random() % probes);
    if (i < 2) {  // one room that lies across the border at x = 0, in numbers from each sector's corner
      const double corner = geometry::kSector_m * s.id.x;
      s.room = {{{{-6.0 - corner, 0.0, 20.0}, {9.0 - corner, 6.0, 32.0}}, 3}};
      s.door = {{{{-4.0 - corner, 0.0, 29.0}, {7.0 - corner, 5.0, 35.5}}, 0}};
      for (std::size_t p = 0; p < probes; ++p) s.in_room.push_back(p == 3 || random() % 5 == 0 ? 1 : 0);
    }
    s.settings = "{}";
    sector.push_back(s);
  }
  reindex();
  index.sun = sun;
  if (sun == transfer::SunTransfer::directional) {
    index.sun_path = file.sky.sun.path;
    index.moon_path = file.sky.moon->path;
  }
  index.scale = {0.75, 1.5};
  index.ground_albedo = {0.3, 0.2, 0.1};
  index.settings = "{}";
}

void RandomLevel::seal(std::size_t i) {
  const auto bytes = sectorBytes(i);
  index.sector[i].bytes = bytes.size();
  index.sector[i].checksum = base::hashOf(std::span<const std::byte>(bytes));
}

void RandomLevel::reindex() {
  index.sector.clear();
  for (const sectors::SectorFile& s : sector) {
    const auto bytes = sectors::encodeSector(s);
    const std::size_t probes = s.probes.sky_scale.size();
    index.sector.push_back({s.id, probes, bytes.size(), base::hashOf(std::span<const std::byte>(bytes)), {}});
  }
  index.all_sectors = sectors::hashOf(index.sector);
}

void RandomLevel::addLocal(std::size_t lights, std::size_t transfers, unsigned seed) {
  std::mt19937 random(seed);
  const auto in = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  std::vector<std::vector<f64::Number3>> own(sector.size());
  for (std::size_t i = 0; i < sector.size(); ++i)
    for (std::size_t l = 0; l < lights; ++l)
      own[i].push_back(geometry::cornerOf(sector[i].id) + f64::Number3(in(0, 64), in(0, 6), in(0, 64)));
  for (std::size_t i = 0; i < sector.size(); ++i) {
    std::vector<f64::Number3> near = own[i];
    if (i > 0) near.insert(near.begin(), own[i - 1].begin(), own[i - 1].end());
    if (i + 1 < own.size()) near.insert(near.end(), own[i + 1].begin(), own[i + 1].end());
    sectors::BakedLocal local;
    local.encoded =
        randomLocal(near, geometry::cornerOf(sector[i].id), sector[i].probes.sky_scale.size(), transfers, random);
    sector[i].local = local;
    sector[i].room.clear();
    sector[i].in_room.clear();
    sector[i].door.clear();
  }
  reindex();
}

OpenedLevel::OpenedLevel(const RandomLevel& baked, const WelkinAllocator* allocator) {
  files.emplace_back(baked.sky);
  demand(welkin_sky_open_memory(files[0].data(), files[0].size, &sky, nullptr), welkin_argument_error());
  files.emplace_back(sectors::encodeLevel(baked.index));
  WelkinOpenInfo info{};
  info.data = files[1].data();
  info.size = files[1].size;
  info.allocator = allocator;
  WelkinMessage message{};
  demand(welkin_level_open(&info, sky, nullptr, &level, &message), message.text);
  for (std::size_t i = 0; i < baked.sector.size(); ++i) {
    files.emplace_back(baked.sectorBytes(i));
    WelkinSector* sector = nullptr;
    demand(welkin_sector_open(level, files.back().data(), files.back().size, &sector, &message), message.text);
    demand(welkin_level_add(level, sector), welkin_argument_error());
  }
}

OpenedLevel::~OpenedLevel() {
  welkin_level_close(level);
  welkin_sky_close(sky);
}

WelkinSkySample OpenedLevel::sampleAt(double time_h) const {
  WelkinSkySample sample{};
  demand(welkin_sky_sample(sky, time_h, &sample), welkin_argument_error());
  return sample;
}

WelkinSkySample OpenedLevel::relight(double time_h, float sky_factor, float sun_factor, float local) {
  const WelkinSkySample sample = sampleAt(time_h);
  WelkinLevelLight light{};
  light.sample = &sample;
  light.sky = sky_factor;
  light.sun_bounce = sun_factor;
  light.local = local;
  demand(welkin_level_set_light(level, &light), welkin_argument_error());
  demand(welkin_level_relight(level, UINT32_MAX, nullptr), welkin_argument_error());
  return sample;
}

sectors::LightOfDay lightOf(const WelkinSkySample& s) {
  using f64::Number3;
  sectors::LightOfDay day;
  const auto vectorOf = [](const float v[3]) { return Number3(double{v[0]}, double{v[1]}, double{v[2]}); };
  // The lower hemisphere of radiance 1 has the coefficients sqrt(pi) and -sqrt(3 pi) / 2 of the constant and of y.
  const double ground[4] = {std::sqrt(f64::kPi), -std::sqrt(3.0 * f64::kPi) / 2.0, 0.0, 0.0};
  for (std::size_t k = 0; k < 4; ++k)
    day.sky_sh[k] = vectorOf(s.ambient_sh[k]) - vectorOf(s.ambient_ground) * ground[k];
  day.sun = {vectorOf(s.sun.direction), vectorOf(s.sun.normal_irradiance) * double{s.sun.visible}};
  day.moon = {vectorOf(s.moon.direction), vectorOf(s.moon.normal_irradiance) * double{s.moon.visible}};
  return day;
}

}  // namespace welkin::tests
