// SPDX-License-Identifier: Apache-2.0
// Runs the viewer.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace welkin::view {

struct ViewOptions {
  std::filesystem::path folder;  ///< of a baked level
  std::filesystem::path level;   ///< level.toml; empty: in the folder or beside it
  std::string script;            ///< commands to perform first; empty: none
  std::string screenshot;        ///< PNG to write at the end; empty: none
  std::string state;             ///< JSON to write at the end; empty: none
  uint32_t width = 1280, height = 720;
  bool has_size = false;  ///< the size is asked for; else a window has that of the last run
  bool validate = false;
};

/// Without a window: performs the script, writes what is asked for and ends. Throws Error, of usage without script,
/// screenshot and state.
void runHeadless(const ViewOptions& options);

}  // namespace welkin::view
