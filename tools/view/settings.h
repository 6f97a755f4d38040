// SPDX-License-Identifier: Apache-2.0
// What the viewer's window keeps between runs.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

namespace welkin::view {

class Session;
struct State;

struct Settings {
  uint32_t width = 1280, height = 720;  ///< of the window, pixels, in [64, 16384]
  std::optional<double> exposure_ev;    ///< in [-40, 40]; none: automatic
  bool bounds = false;
  std::size_t truth_paths = 4096;  ///< in [1, 2^24]
  std::size_t pixel_paths = 8;     ///< in [1, 4096]
  friend bool operator==(const Settings&, const Settings&) = default;
};

/// view.json in a folder, such as configFolder(). The defaults where it is missing; a value that is none, or outside of
/// its range, is its default.
Settings readSettings(const std::filesystem::path& folder);

/// Writes the file whole. A folder that cannot be written, or an empty path, is no error: then nothing is kept.
void writeSettings(const std::filesystem::path& folder, const Settings& settings);

Settings settingsOf(const Session& session);
void apply(const Settings& settings, State& state);

}  // namespace welkin::view
