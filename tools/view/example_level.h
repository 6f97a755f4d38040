// SPDX-License-Identifier: Apache-2.0
// The level that the viewer shows when none is named: examples/island, baked on first use.
#pragma once

#include <filesystem>

#include "sky/base/progress.h"

namespace welkin::view {

/// level.toml of examples/island: beside the program in a build or source tree, or as installed, in
/// share/welkin/examples. Throws Error(file) that says where it was looked for.
std::filesystem::path exampleLevel();

/// The folder of its bake in the user's cache. It is baked if there is no whole bake by this version of the program.
/// Throws Error, of file without a home folder.
std::filesystem::path bakedExample(const base::Progress& progress);

}  // namespace welkin::view
