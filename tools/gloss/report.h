// SPDX-License-Identifier: Apache-2.0
// What a run on one texture found, as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "gloss/write_gloss.h"

namespace welkin::gloss {

/// Names, coding, direction of green, average Toksvig factor, errors of blocks, every mip's means, warnings and files.
nlohmann::ordered_json reportOf(const Result& result);

}  // namespace welkin::gloss
