// SPDX-License-Identifier: Apache-2.0
#include "render/level_query.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "render/place.h"
#include "render/runtime_sky.h"

namespace welkin::render {

FloatImage queryPlaces(const WelkinLevel& level, const FloatImage& places, const Camera& camera,
                       const f64::Number3& position) {
  using Row = std::array<float, 3>;
  std::vector<std::size_t> texel;
  std::vector<Row> at;
  std::vector<Row> normal;
  const PlaceOf place_of(places, camera, position);
  for (uint32_t y = 0; y < places.height; ++y)
    for (uint32_t x = 0; x < places.width; ++x)
      if (const auto place = place_of(x, y)) {
        const auto row = [](const f64::Number3& v) {
          return Row{static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
        };
        texel.push_back(std::size_t{y} * places.width + x);
        at.push_back(row(place->position));
        normal.push_back(row(place->normal));
      }
  const auto rows = [](std::vector<Row>& v) { return reinterpret_cast<float(*)[3]>(v.data()); };
  std::vector<Row> irradiance(at.size());
  std::vector<std::uint8_t> served(at.size());
  require(welkin_level_irradiance(&level, at.size(), rows(at), rows(normal), rows(irradiance), served.data()),
          "welkin_level_irradiance");
  FloatImage image{places.width, places.height, std::vector<float>(places.rgba.size())};
  for (std::size_t i = 0; i < texel.size(); ++i) {
    if (served[i] == 0) continue;
    for (std::size_t c = 0; c < 3; ++c) image.rgba[4 * texel[i] + c] = irradiance[i][c];
    image.rgba[4 * texel[i] + 3] = 1.0F;
  }
  return image;
}

}  // namespace welkin::render
