// SPDX-License-Identifier: Apache-2.0
// A day sampled at a few hours, as tables are planned from it, and the normals and skies of the tests.
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>
#include <welkin/welkin.hpp>

#include "degree.h"
#include "sky/bake/encode.h"
#include "sky/base/toml_table.h"
#include "sky/table/representation.h"

namespace welkin::tests {

struct SampledDay {
  model::Sky sky;
  table::DayFields fields;
  table::ErrorGrid grid;
  table::DayValues values;

  SampledDay(model::Sky sky_, const std::vector<double>& time_h)
      : sky(std::move(sky_)),
        fields(table::sampleDay(sky, time_h, table::brightestOf(sky), {})),
        values(fields, grid) {}
  SampledDay(const SampledDay&) = delete;
  SampledDay& operator=(const SampledDay&) = delete;
};

/// A grey sky of intensity 1 whose sun stands still at an elevation, azimuth 40 degrees.
inline model::Sky stillSky(const model::LuminanceModel& model, double elevation_deg) {
  model::Sky sky;
  sky.luminance = model;
  sky.sun.path.key_time_h = {0.0};
  sky.sun.path.key_azimuth_rad = {40.0 * kDegree};
  sky.sun.path.key_elevation_rad = {elevation_deg * kDegree};
  return sky;
}

/// World direction of a normal of component y, at an azimuth from the sun's at the instant.
inline det::Number3 normalAt(const model::SkyInstant& instant, double y, double alpha) {
  const double across = std::sqrt(std::max(1.0 - y * y, 0.0));
  const double azimuth = std::atan2(instant.sunDirection().x, -instant.sunDirection().z) + alpha;
  return {across * std::sin(azimuth), y, -across * std::cos(azimuth)};
}

/// A table in the file of a sky, opened by the runtime. Throws std::runtime_error with the runtime's message.
struct OpenedTable {
  std::vector<std::byte> bytes;
  welkin::Sky sky;

  OpenedTable(const model::Sky& model, const table::DayTable& table,
              table::Encoding encoding = table::Encoding::float32) {
    bake::SkyFile file;
    file.sky = model;
    file.settings = "{}";
    file.bake.key_time_h = table.key_time_h;
    bytes = bake::encodeSky(file, table, {}, encoding);
    const Status status = sky.open(bytes.data(), bytes.size());
    if (!status) throw std::runtime_error(std::string("the runtime refuses the table: ") + status.message);
  }

  WelkinSkySample at(double time_h) const {
    WelkinSkySample sample{};
    if (!sky.sample(time_h, sample)) throw std::runtime_error("the runtime cannot sample the table");
    return sample;
  }
  det::Number3 irradiance(const WelkinSkySample& sample, const det::Number3& normal) const {
    const float n[3] = {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)};
    float e[3];
    if (welkin_sky_irradiance(sky.get(), &sample, n, e) != WELKIN_OK)
      throw std::runtime_error("the runtime gives no irradiance");
    return {double{e[0]}, double{e[1]}, double{e[2]}};
  }
};

}  // namespace welkin::tests
