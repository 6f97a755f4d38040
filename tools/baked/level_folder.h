// SPDX-License-Identifier: Apache-2.0
// A folder of a baked level, opened by the runtime with all of its sectors resident.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <vector>
#include <welkin/level.hpp>

#include "probes/reference/light_path.h"

namespace welkin::baked {

struct SurfacePoint {
  f64::Number3 position;  ///< metres
  f64::Number3 normal;    ///< unit
};

/// Irradiance of a surface by its sources, RGB, pi included.
struct PointLight {
  Float3 irradiance{};
  Float3 sky{}, sun_bounce{}, local{};  ///< they add up to `irradiance`
};

class LevelFolder {
 public:
  /// Files in place of the folder's, by their path with it.
  using Instead = std::map<std::filesystem::path, std::vector<std::byte>>;

  /// Opens every file of a level that is to have at most `lights` dynamic lights. Throws Error.
  explicit LevelFolder(const std::filesystem::path& folder, std::size_t lights = 0, const Instead& instead = {});

  /// Whether nothing stands between two places.
  using Sees = std::function<bool(const f64::Number3& from, const f64::Number3& to)>;

  /// Sets the dynamic lights. `sees` tells which virtual lights see them; without it every one near enough does.
  /// Returns how many none sees. Throws Error.
  std::size_t setLights(const std::vector<reference::LocalLight>& lights, const Sees& sees = {});

  /// The light at each point, nothing where no probe serves.
  std::vector<std::optional<PointLight>> at(const std::vector<SurfacePoint>& points, double time_h);

  /// Rises whenever a call has changed the light of the probes.
  std::size_t lightChanges() const { return light_changes_; }

  const Sky& sky() const { return sky_; }
  Level& level() { return level_; }

 private:
  /// A file's bytes, aligned for the runtime.
  struct Bytes {
    std::vector<std::max_align_t> room;
    std::size_t size = 0;
  };

  std::size_t light_changes_ = 0;
  Sky sky_;
  std::vector<Bytes> files_;
  Level level_;  ///< last: it reads the files
};

}  // namespace welkin::baked
