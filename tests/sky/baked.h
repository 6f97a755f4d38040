// SPDX-License-Identifier: Apache-2.0
// A sky that is baked and opened by the runtime, as a game would have it.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>
#include <welkin/welkin.hpp>

#include "sky/encode.h"
#include "sky/toml_table.h"

namespace welkin::test {

/// Throws std::runtime_error with the runtime's message when it does not open what was baked.
struct Baked {
  std::vector<std::byte> bytes;
  sky::DayTable table;
  welkin::Sky sky;

  Baked(const sky::Sky& model, int bands, const std::vector<double>& key_time_h) {
    sky::SkyFile file;
    file.sky = model;
    file.settings = "{}";
    file.bake.key_time_h = key_time_h;
    table = sky::bakeDayTable(model, bands, key_time_h, [] { return true; });
    bytes = sky::encodeSky(file, table, {});
    const Status status = sky.open(bytes.data(), bytes.size());
    if (!status) throw std::runtime_error(std::string("the runtime refuses what was baked: ") + status.message);
  }
  /// Keys spread evenly.
  Baked(const sky::Sky& model, int bands, int keys) : Baked(model, bands, sky::evenHours(keys)) {}
};

}  // namespace welkin::test
