// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/exercise_level.h"

#include <welkin/volume.h>

#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <new>
#include <stdexcept>

#include "format/container.h"
#include "format/domain_check.h"
#include "format/sector_check.h"
#include "tests/runtime/random_level.h"

namespace welkin::tests {
namespace {

using transfer::SunTransfer;
using Position = std::array<float, 3>;

/// A copy of the exact size, so that a sanitizer sees each read past the end.
class ExactBytes {
 public:
  explicit ExactBytes(std::span<const std::byte> bytes)
      : bytes_(static_cast<std::byte*>(::operator new(bytes.size(), kAlignment))), size_(bytes.size()) {
    if (size_ > 0) std::memcpy(bytes_, bytes.data(), size_);
  }
  ExactBytes(const ExactBytes&) = delete;
  ExactBytes& operator=(const ExactBytes&) = delete;
  ~ExactBytes() { ::operator delete(bytes_, kAlignment); }
  std::span<std::byte> span() const { return {bytes_, size_}; }
  const void* data() const { return bytes_; }
  std::size_t size() const { return size_; }

 private:
  static constexpr std::align_val_t kAlignment{format::kAlignment};
  std::byte* bytes_;
  std::size_t size_;
};

void ensure(bool holds, const std::string& rule) {
  if (!holds) throw std::logic_error(rule);
}
void succeed(WelkinResult result, const char* call) {
  ensure(result == WELKIN_OK, std::string(call) + " succeeds: " + welkin_argument_error());
}
void ensureFinite(const float* values, std::size_t count, const char* what) {
  ensure(std::all_of(values, values + count, [](float v) { return std::isfinite(v); }),
         std::string(what) + " is finite");
}

/// The level that stands beside a mutated file, for each form of the bounced sun.
struct Beside {
  RandomLevel level;
  WelkinSky* sky = nullptr;
  AlignedBytes sky_bytes;

  explicit Beside(SunTransfer sun)
      : level(2, 11, sun == SunTransfer::directional ? 3 : 0, sun, true), sky_bytes(level.sky) {
    succeed(welkin_sky_open_memory(sky_bytes.data(), sky_bytes.size, &sky, nullptr), "sky_open");
  }
};
const Beside& besideOf(SunTransfer sun) {
  static const Beside kNone(SunTransfer::none), kSh(SunTransfer::sh), kDirectional(SunTransfer::directional);
  return sun == SunTransfer::directional ? kDirectional : sun == SunTransfer::sh ? kSh : kNone;
}

/// The same file with new bytes inside, under a right checksum.
std::vector<std::byte> resealed(std::span<const std::byte> file, format::Kind kind) {
  const auto payload = file.subspan(sizeof(format::Header));
  return format::seal({reinterpret_cast<const std::uint8_t*>(payload.data()), payload.size()}, kind);
}

/// Light at positions, in every way that the interface gives it.
void lookUp(const WelkinLevel* level, const std::vector<Position>& positions) {
  constexpr float kNormals[][3] = {{0, 1, 0}, {0, -1, 0}, {1, 0, 0}, {-0.6F, 0, -0.8F}};
  for (const Position& p : positions) {
    const auto* position = reinterpret_cast<const float(*)[3]>(&p);
    float rgb[3], sh[4][3];
    std::uint8_t served = 2;
    for (const auto& normal : kNormals) {
      succeed(welkin_level_irradiance(level, 1, position, &normal, &rgb, &served), "level_irradiance");
      ensureFinite(rgb, 3, "a look-up");
      ensure(std::min({rgb[0], rgb[1], rgb[2]}) >= 0.0F && served <= 1, "a look-up is at least 0, and served or not");
    }
    WelkinColours colours;
    succeed(welkin_level_colours(level, 1, position, &colours, &served), "level_colours");
    ensureFinite(&colours.irradiance[0][0], 12, "a colour");
    succeed(welkin_colours_irradiance(&colours, kNormals[3], rgb), "colours_irradiance");
    ensureFinite(rgb, 3, "a colour's irradiance");
    succeed(welkin_colours_sh(&colours, sh), "colours_sh");
    ensureFinite(&sh[0][0], 12, "a colour's SH");
  }
}

void fillVolume(WelkinLevel* level, const WelkinSkySample& sample, WelkinVolumeFormat format, const Position& middle) {
  WelkinVolumeSettings settings{};
  settings.format = format;
  settings.texels[0] = 6;
  settings.texels[1] = settings.texels[2] = 4;
  settings.bricks = 128;  // little memory to clear for each file
  WelkinVolume* made = nullptr;
  succeed(welkin_volume_create(&settings, &made), "volume_create");
  const std::unique_ptr<WelkinVolume, decltype(&welkin_volume_destroy)> volume(made, welkin_volume_destroy);
  for (const float moved : {0.0F, 5.0F, -3.0F, 70.0F}) {
    const Position camera = {middle[0] + moved, middle[1], middle[2] - moved};
    WelkinVolumeUpdate update{};
    succeed(welkin_volume_update(made, level, &sample, camera.data(), 16, &update), "volume_update");
    ensure(update.box_count <= WELKIN_VOLUME_MAX_BOXES, "an update has few boxes");
    for (const float y : {-9.0F, 0.0F, 9.0F}) {
      const float position[3] = {camera[0] + y, camera[1] + 0.5F * y, camera[2]}, up[3] = {0, 1, 0};
      float rgb[3], inside = -1.0F;
      succeed(welkin_volume_irradiance(made, position, up, rgb, &inside), "volume_irradiance");
      ensureFinite(rgb, 3, "the volume");
      ensure(inside >= 0.0F && inside <= 1.0F, "the volume's share is 0 to 1");
    }
  }
}

/// Puts a lamp and a spot at each position, with any revision.
void setLights(WelkinLevel* level, const std::vector<Position>& positions, std::uint32_t revision) {
  std::vector<WelkinPointLight> lights;
  for (const Position& p : positions) {
    if (std::abs(p[0]) > 1e9F || std::abs(p[1]) > 1e9F || std::abs(p[2]) > 1e9F) continue;  // refused
    WelkinPointLight light{{p[0], p[1], p[2]}, {1e15F, 1.0F, 0.0F}, {0.0F, -1.0F, 0.0F}, 0.0F, 0.0F, revision};
    lights.push_back(light);
    light.outer_rad = 1.0F;
    lights.push_back(light);
  }
  const auto sees = [](void*, const float from[3], const float to[3]) { return from[0] + to[1] > 2.0F ? 1 : 0; };
  WelkinLightsResult result{};
  succeed(
      welkin_level_set_lights(level, static_cast<std::uint32_t>(lights.size()), lights.data(), sees, nullptr, &result),
      "set_lights");
  ensure(result.unseen <= lights.size() && result.shared <= lights.size(), "counts of lights are at most their number");
}

/// Relights for some hours and looks everything up.
void exercise(WelkinLevel* level, const WelkinSky* sky, const std::vector<Position>& positions) {
  WelkinLevelInfo info{};
  succeed(welkin_level_info(level, &info), "level_info");
  for (std::uint32_t i = 0; i < std::min(info.sector_count, 16U); ++i) {
    WelkinSectorEntry entry{};
    succeed(welkin_level_entry(level, i, &entry), "level_entry");
  }
  for (const double time_h : {2.0, 5.9, 12.0, 18.3}) {
    WelkinSkySample sample{};
    succeed(welkin_sky_sample(sky, time_h, &sample), "sky_sample");
    WelkinLevelLight light{};
    light.sample = &sample;
    light.sky = light.sun_bounce = light.local = 1.0F;
    succeed(welkin_level_set_light(level, &light), "set_light");
    setLights(level, positions, time_h < 12.0 ? 0 : 1);
    WelkinRelight relit{};
    succeed(welkin_level_relight(level, 5, &relit), "relight");
    ensure(relit.relit <= 5 && relit.relit + relit.remaining == info.resident_probes, "the budget is kept");
    lookUp(level, {positions.front()});
    std::uint32_t count = 0;
    succeed(welkin_level_relight_begin(level, UINT32_MAX, &count), "relight_begin");
    succeed(welkin_level_relight_range(level, count / 2, count - count / 2), "relight_range");
    succeed(welkin_level_relight_range(level, 0, count / 2), "relight_range");
    succeed(welkin_level_relight_end(level, &relit), "relight_end");
    if (time_h < 12.0) continue;
    lookUp(level, positions);
    fillVolume(level, sample, time_h == 12.0 ? WELKIN_VOLUME_RGBA16F : WELKIN_VOLUME_RGBA8, positions.back());
  }
}

struct CloseLevel {
  void operator()(WelkinLevel* level) const { welkin_level_close(level); }
};
using LevelPointer = std::unique_ptr<WelkinLevel, CloseLevel>;

/// Null if the runtime refuses the index.
LevelPointer openIndex(const ExactBytes& index, const WelkinSky* sky) {
  WelkinOpenInfo info{};
  info.data = index.data();
  info.size = index.size();
  WelkinLevel* level = nullptr;
  WelkinMessage message{};
  const WelkinResult result = welkin_level_open(&info, sky, nullptr, &level, &message);
  ensure((result == WELKIN_OK) == (level != nullptr), "a level is there exactly when it opened");
  ensure(result == WELKIN_OK || message.text[0] != '\0', "a refused index has a message");
  return LevelPointer(level);
}

/// Opens a sector and makes it resident. False if the runtime refuses it.
bool addSector(WelkinLevel* level, const ExactBytes& bytes) {
  WelkinSector* sector = nullptr;
  WelkinMessage message{};
  const WelkinResult result = welkin_sector_open(level, bytes.data(), bytes.size(), &sector, &message);
  ensure((result == WELKIN_OK) == (sector != nullptr), "a sector is there exactly when it opened");
  ensure(result == WELKIN_OK || message.text[0] != '\0', "a refused sector has a message");
  if (sector == nullptr) return false;
  const WelkinResult added = welkin_level_add(level, sector);
  if (added != WELKIN_OK) welkin_sector_close(sector);
  succeed(added, "level_add");
  return true;
}

/// Positions in a sector that the runtime accepted: corners, borders, rooms and cells that walls part.
std::vector<Position> positionsIn(const format::Sector& s) {
  const auto at = [&](double x, double y, double z) {
    return Position{static_cast<float>(64.0 * s.x() + x), static_cast<float>(y), static_cast<float>(64.0 * s.z() + z)};
  };
  const double low = double{s.low_y()}, cell = double{s.cell_height_m()};
  std::vector<Position> positions;
  for (const double x : {0.3, 2.0, 31.9, 63.9, 64.4})
    for (const double y : {low - 0.5 * cell, low + 0.5 * cell, low + 3.2 * cell, low + 16.1 * cell})
      positions.push_back(at(x, y, 63.0 - 0.7 * x));
  if (s.room() != nullptr)
    for (std::uint32_t i = 0; i < std::min(s.room()->size(), 8U); ++i) {
      const format::Room& r = *s.room()->Get(i);
      positions.push_back(at(double{r.low_x()}, double{r.low_y()}, double{r.low_z()}));
      positions.push_back(at(double{r.high_x()}, double{r.high_y()}, double{r.high_z()}));
    }
  const format::CellCuts cuts = format::cutsOf(s);
  for (std::size_t i = 0; i < std::min<std::size_t>(cuts.cell.size(), 16); ++i) {
    const int c = cuts.cell[i];
    positions.push_back(at(4.0 * (c % 16) + 1.3, low + cell * (c / 16 % 16 + 0.6), 4.0 * (c / 256) + 2.7));
  }
  positions.push_back(at(60.0, low + 2.0 * cell, 30.0));
  return positions;
}

/// The sector's file with another x; empty where the file leaves x out, as it does for 0.
std::vector<std::byte> movedTo(std::int32_t x, std::span<const std::byte> file) {
  const ExactBytes copy(file);
  const auto* sector = format::openContainer(copy.span()).file->sector();
  const auto* field = reinterpret_cast<const flatbuffers::Table*>(sector)->GetAddressOf(format::Sector::VT_X);
  if (field == nullptr) return {};
  std::memcpy(copy.span().data() + (reinterpret_cast<const std::byte*>(field) - copy.span().data()), &x, sizeof x);
  return resealed(copy.span(), format::Kind::sector);
}

LevelExercise exerciseSector(const ExactBytes& bytes, const format::File& file) {
  const format::Sector& sector = *file.sector();
  const bool sane = std::abs(std::int64_t{sector.x()}) < format::kFarthestSector &&
                    std::abs(std::int64_t{sector.z()}) < format::kFarthestSector &&
                    sector.sun() <= format::SunTransfer::MAX;
  const Beside& beside = besideOf(sane ? static_cast<SunTransfer>(sector.sun()) : SunTransfer::none);
  sectors::LevelIndex index = beside.level.index;
  index.sector.clear();
  const std::int32_t x = sane ? sector.x() : 0, z = sane ? sector.z() : 0;
  std::vector<std::byte> neighbour;
  if (sane) neighbour = movedTo(x < 0 ? x + 1 : x - 1, bytes.span());
  const auto add = [&](std::int32_t at, std::span<const std::byte> named) {
    index.sector.push_back({{at, z}, 0, named.size(), base::hashOf(named), {}});
  };
  if (x >= 0 && !neighbour.empty()) add(x - 1, neighbour);
  add(x, bytes.span());
  if (x < 0 && !neighbour.empty()) add(x + 1, neighbour);
  const ExactBytes written(sectors::encodeLevel(index));
  const ExactBytes second(neighbour);
  const LevelPointer level = openIndex(written, beside.sky);
  ensure(level != nullptr, "the right index opens");
  if (!addSector(level.get(), bytes)) return {};
  if (!neighbour.empty()) addSector(level.get(), second);
  exercise(level.get(), beside.sky, positionsIn(sector));
  // The sector leaves and comes back.
  WelkinSector* removed = nullptr;
  succeed(welkin_level_remove(level.get(), x, z, &removed), "level_remove");
  ensure(removed != nullptr, "the sector was resident");
  lookUp(level.get(), {positionsIn(sector).front()});
  setLights(level.get(), positionsIn(sector), 1);
  succeed(welkin_level_add(level.get(), removed), "level_add");
  setLights(level.get(), positionsIn(sector), 1);
  return {true, {}};
}

LevelExercise exerciseIndex(const ExactBytes& bytes, const format::Level& named) {
  const auto sun = named.sun() <= format::SunTransfer::MAX ? static_cast<SunTransfer>(named.sun()) : SunTransfer::none;
  const Beside& beside = besideOf(sun);
  const auto* entries = named.sectors();
  if (entries != nullptr && reinterpret_cast<std::uintptr_t>(entries->Data()) % alignof(format::SectorEntry) == 0)
    for (const format::SectorEntry* entry : *entries)
      for (std::size_t i = 0; i < beside.level.sector.size(); ++i) {
        if (entry->x() != beside.level.sector[i].id.x || entry->z() != beside.level.sector[i].id.z) continue;
        const auto of_sector = base::hashOf(std::span<const std::byte>(beside.level.sectorBytes(i)));
        const format::Hash checksum(of_sector.low, of_sector.high);
        const auto* field = reinterpret_cast<const std::byte*>(&entry->checksum());
        std::memcpy(bytes.span().data() + (field - bytes.span().data()), &checksum, sizeof checksum);
      }
  const ExactBytes right(resealed(bytes.span(), format::Kind::level));
  const LevelPointer level = openIndex(right, beside.sky);
  if (level == nullptr) return {};
  std::vector<std::unique_ptr<ExactBytes>> files;
  for (std::size_t i = 0; i < beside.level.sector.size(); ++i) {
    files.push_back(std::make_unique<ExactBytes>(beside.level.sectorBytes(i)));
    addSector(level.get(), *files.back());
  }
  exercise(level.get(), beside.sky, {{-10, 4, 20}, {-0.1F, 6, 30}, {0.1F, 6, 30}, {20, 40, 20}});
  return {true, {}};
}

/// A file that the container refuses is refused as both kinds.
LevelExercise exerciseForeign(const ExactBytes& bytes) {
  const Beside& beside = besideOf(SunTransfer::sh);
  ensure(openIndex(bytes, beside.sky) == nullptr, "a damaged file is no index");
  const ExactBytes written(sectors::encodeLevel(beside.level.index));
  const LevelPointer level = openIndex(written, beside.sky);
  ensure(level != nullptr && !addSector(level.get(), bytes), "a damaged file is no sector");
  return {};
}

}  // namespace

LevelExercise exerciseFile(std::span<const std::byte> file) try {
  const ExactBytes bytes(file);
  const format::Opened container = format::openContainer(bytes.span());
  const bool whole = container.refusal == format::Refusal::none;
  if (whole && container.kind == format::Kind::sector && container.file->sector() != nullptr)
    return exerciseSector(bytes, *container.file);
  if (whole && container.kind == format::Kind::level && container.file->level() != nullptr)
    return exerciseIndex(bytes, *container.file->level());
  return exerciseForeign(bytes);
} catch (const std::logic_error& broken) {
  return {false, broken.what()};
}

}  // namespace welkin::tests
