// SPDX-License-Identifier: Apache-2.0
// The plan of a bake: what it would make, and why, without making it.
#pragma once

#include <nlohmann/json.hpp>

#include "probes/build/bake_file.h"

namespace welkin::build {

/// What a bake would do with the sky and with every sector: their tables, bytes, and why each is to be baked. Without a
/// folder, a new one. Bytes of a sector that is out of date are about those that it will have. Throws Error.
nlohmann::ordered_json planFile(const BakeRequest& request, const BakeInput& read, const base::Progress& progress);

}  // namespace welkin::build
