// SPDX-License-Identifier: Apache-2.0
// A table of a sampled day as a bake makes one, and its certificate.
#pragma once

#include "sampled_day.h"
#include "sky/bake/certify.h"

namespace welkin::tests {

/// Every sampled hour is a key.
struct BakedDay {
  const SampledDay& day;
  table::Representation representation;
  table::Encoding encoding;
  table::DayTable table;
  OpenedTable opened;

  BakedDay(const SampledDay& day_, table::Representation r, table::Encoding encoding_ = table::Encoding::float32)
      : day(day_),
        representation(std::move(r)),
        encoding(encoding_),
        table(tableOf()),
        opened(day.sky, table, encoding) {}

  /// Of `file` in place of the table's own when there is one.
  table::Certificate certificate(double step_h, bake::Certify how = bake::Certify::fast,
                                 const OpenedTable* file = nullptr) const {
    return bake::certify(
        (file != nullptr ? *file : opened).sky.get(),
        {day.sky, representation, table, encoding, {0.0, &model::kIrradianceRules[0]}, table::brightestOf(day.sky)},
        how, {}, step_h);
  }

 private:
  table::DayTable tableOf() const {
    std::vector<std::size_t> keys(day.fields.instant.size());
    for (std::size_t i = 0; i < keys.size(); ++i) keys[i] = i;
    return table::tableAt(day.values, representation, keys);
  }
};

/// Unit directions spread evenly, along meridians of equal areas: not those of the certificate.
inline std::vector<det::Number3> evenNormals(int rows, int columns) {
  std::vector<det::Number3> normals;
  for (int j = 0; j <= rows; ++j) {
    const double y = std::cos(M_PI * j / rows);
    for (int i = 0; i < columns; ++i) {
      const double azimuth = 2.0 * M_PI * (i + 0.37) / columns;
      normals.push_back(
          {std::sin(M_PI * j / rows) * std::sin(azimuth), y, std::sin(M_PI * j / rows) * std::cos(azimuth)});
    }
  }
  return normals;
}

/// The error's divisor by its definition, for a day that is nowhere near 1e-4 of its brightest: by channel the mean of
/// E over all normals, or of its luminance when that is more.
inline det::Number3 divisorOf(const model::SkyInstant& instant) {
  const model::SkyProjector projector(instant.sky().luminance, 1, 1e-9);
  const auto moments = projector.project(instant);
  const det::Number3 ground = instant.groundRadiance(moments.horizontal_irradiance);
  // The mean of the clipped cosine over the sphere of normals is a quarter: E is pi/4 x 4 x the mean radiance.
  const det::Number3 mean = det::desaturate(
      moments.radiance_sh[0] * (std::sqrt(4.0 * M_PI) / 4.0 * instant.intensity()) + ground * (M_PI / 2.0),
      instant.sky().ambient_saturation.at(instant.time_h()));
  const double luminance = 0.2126 * mean.x + 0.7152 * mean.y + 0.0722 * mean.z;
  return {std::max(mean.x, luminance), std::max(mean.y, luminance), std::max(mean.z, luminance)};
}

}  // namespace welkin::tests
