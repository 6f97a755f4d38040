// SPDX-License-Identifier: Apache-2.0
// C++17 wrapper of level.h, header only. It adds ownership and results with messages, nothing else. Conventions, units,
// errors and the rules of threads are those of level.h.
#pragma once

#include <welkin/level.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <welkin/welkin.hpp>

namespace welkin {

/// Owns a sector that is not resident. Movable.
class Sector {
 public:
  Sector() = default;
  explicit Sector(WelkinSector* sector) : sector_(sector) {}
  Sector(Sector&& other) noexcept : sector_(std::exchange(other.sector_, nullptr)) {}
  Sector& operator=(Sector&& other) noexcept {
    std::swap(sector_, other.sector_);
    return *this;
  }
  Sector(const Sector&) = delete;
  Sector& operator=(const Sector&) = delete;
  ~Sector() { welkin_sector_close(sector_); }

  WelkinSector* get() const { return sector_; }
  explicit operator bool() const { return sector_ != nullptr; }
  /// Gives up the sector, such as to a level.
  WelkinSector* release() { return std::exchange(sector_, nullptr); }

 private:
  WelkinSector* sector_ = nullptr;
};

/// Owns a WelkinLevel. Movable; empty until an open succeeds.
class Level {
 public:
  Level() = default;
  Level(Level&& other) noexcept : level_(std::exchange(other.level_, nullptr)) {}
  Level& operator=(Level&& other) noexcept {
    std::swap(level_, other.level_);
    return *this;
  }
  Level(const Level&) = delete;
  Level& operator=(const Level&) = delete;
  ~Level() { welkin_level_close(level_); }

  /// Opens an index and closes the level held before. On an error the level held before stays open.
  Status open(const WelkinOpenInfo& info, const Sky& sky, const WelkinLevelLimits& limits = {}) {
    WelkinLevel* level = nullptr;
    WelkinMessage message{};
    const WelkinResult code = welkin_level_open(&info, sky.get(), &limits, &level, &message);
    if (code != WELKIN_OK) return {code, message.text};
    welkin_level_close(std::exchange(level_, level));
    return {};
  }
  Status open(const std::string& path, const Sky& sky) {
    WelkinOpenInfo info{};
    info.path = path.c_str();
    return open(info, sky);
  }

  /// The level for the functions of level.h; null when none is open.
  WelkinLevel* get() const { return level_; }
  explicit operator bool() const { return level_ != nullptr; }

  WelkinLevelInfo info() const {
    WelkinLevelInfo value{};
    welkin_level_info(level_, &value);
    return value;
  }
  Status entry(std::uint32_t index, WelkinSectorEntry& entry) const {
    return statusOf(welkin_level_entry(level_, index, &entry));
  }

  /// Checks the bytes of a sector's file, which stay in place and unchanged. Any thread may call it.
  Status openSector(const void* data, std::size_t size, Sector& sector) const {
    WelkinSector* opened = nullptr;
    WelkinMessage message{};
    const WelkinResult code = welkin_sector_open(level_, data, size, &opened, &message);
    if (code != WELKIN_OK) return {code, message.text};
    sector = Sector(opened);
    return {};
  }
  /// Makes a sector resident. On an error the caller keeps it.
  Status add(Sector& sector) {
    const WelkinResult code = welkin_level_add(level_, sector.get());
    if (code == WELKIN_OK) sector.release();
    return statusOf(code);
  }
  /// Ends the residence of a sector; `sector` becomes empty if it was not resident.
  Status remove(std::int32_t x, std::int32_t z, Sector& sector) {
    WelkinSector* removed = nullptr;
    const WelkinResult code = welkin_level_remove(level_, x, z, &removed);
    if (code == WELKIN_OK) sector = Sector(removed);
    return statusOf(code);
  }
  Status farthest(const Float3& position, std::int32_t& x, std::int32_t& z) const {
    return statusOf(welkin_level_farthest(level_, position.data(), &x, &z));
  }

  Status setLight(const WelkinLevelLight& light) { return statusOf(welkin_level_set_light(level_, &light)); }
  /// All dynamic lights. `sees(from, to)` tells whether two points see each other; leave it out if all do.
  template <typename Sees>
  Status setLights(const WelkinPointLight* lights, std::uint32_t count, Sees&& sees, WelkinLightsResult& result) {
    const auto call = [](void* user, const float from[3], const float to[3]) -> int {
      auto& test = *static_cast<std::remove_reference_t<Sees>*>(user);
      return test(Float3{from[0], from[1], from[2]}, Float3{to[0], to[1], to[2]}) ? 1 : 0;
    };
    void* user = const_cast<void*>(static_cast<const void*>(&sees));
    return statusOf(welkin_level_set_lights(level_, count, lights, call, user, &result));
  }
  Status setLights(const WelkinPointLight* lights, std::uint32_t count, WelkinLightsResult& result) {
    return statusOf(welkin_level_set_lights(level_, count, lights, nullptr, nullptr, &result));
  }
  Status relight(std::uint32_t max_probes, WelkinRelight& result) {
    return statusOf(welkin_level_relight(level_, max_probes, &result));
  }
  Status relightBegin(std::uint32_t max_probes, std::uint32_t& count) {
    return statusOf(welkin_level_relight_begin(level_, max_probes, &count));
  }
  Status relightRange(std::uint32_t first, std::uint32_t count) {
    return statusOf(welkin_level_relight_range(level_, first, count));
  }
  Status relightEnd(WelkinRelight& result) { return statusOf(welkin_level_relight_end(level_, &result)); }

  /// Irradiance at one point; `served` becomes false where no probe serves.
  Status irradiance(const Float3& position, const Float3& normal, Float3& rgb, bool& served) const {
    std::uint8_t any = 0;
    const auto row = [](const Float3& v) { return reinterpret_cast<const float(*)[3]>(v.data()); };
    const WelkinResult code =
        welkin_level_irradiance(level_, 1, row(position), row(normal), reinterpret_cast<float(*)[3]>(rgb.data()), &any);
    served = any != 0;
    return statusOf(code);
  }

 private:
  WelkinLevel* level_ = nullptr;
};

}  // namespace welkin
