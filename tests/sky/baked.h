// SPDX-License-Identifier: Apache-2.0
// A sky baked and opened by the runtime, as in a game.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>
#include <welkin/welkin.hpp>

#include "sky/bake/encode.h"
#include "sky/base/toml_table.h"

namespace welkin::tests {

/// Throws std::runtime_error with the runtime's message when the runtime does not open the baked file.
struct Baked {
  std::vector<std::byte> bytes;
  table::DayTable table;
  welkin::Sky sky;

  Baked(const model::Sky& model, int bands, const std::vector<double>& key_time_h) {
    bake::SkyFile file;
    file.sky = model;
    file.settings = "{}";
    file.bake.key_time_h = key_time_h;
    table = table::bakeDayTable(model, bands, key_time_h, {});
    bytes = bake::encodeSky(file, table, {});
    const Status status = sky.open(bytes.data(), bytes.size());
    if (!status) throw std::runtime_error(std::string("the runtime refuses what was baked: ") + status.message);
  }
  /// The keys are evenly spread.
  Baked(const model::Sky& model, int bands, int keys) : Baked(model, bands, base::evenHours(keys)) {}
};

}  // namespace welkin::tests
