// SPDX-License-Identifier: Apache-2.0
#include "maps/sky_map.h"

#include <tbb/parallel_for.h>

#include <cstddef>

namespace welkin::maps {
namespace {

std::size_t indexOf(const Map& map, int column, int row) {
  return 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(map.width) + static_cast<std::size_t>(column));
}

Map emptyMap(int width, int height) {
  Map map{width, height, {}};
  map.rgb.resize(indexOf(map, 0, height));
  return map;
}

/// Fills a map with the light in the direction directionOf(column, row) of every texel.
template <typename DirectionOf>
Map render(const Light& light, int width, int height, DirectionOf&& directionOf) {
  Map map = emptyMap(width, height);
  tbb::parallel_for(0, height, [&](int row) {
    for (int column = 0; column < width; ++column) {
      const Number3 colour = light(directionOf(column, row));
      for (int c = 0; c < 3; ++c)
        map.rgb[indexOf(map, column, row) + static_cast<std::size_t>(c)] = static_cast<float>(colour[c]);
    }
  });
  return map;
}

}  // namespace

Light domeOf(const WelkinSky* sky, const WelkinSkySample& sample) {
  return [sky, &sample](const Number3& towards) {
    const float direction[3] = {static_cast<float>(towards.x), static_cast<float>(towards.y),
                                static_cast<float>(towards.z)};
    float rgb[3] = {};
    welkin_dome_radiance(sky, &sample, direction, rgb);
    return Number3(double{rgb[0]}, double{rgb[1]}, double{rgb[2]});
  };
}

Map cubeOf(const Light& light, const Orientation& orientation, int size) {
  return render(light, size, 6 * size, [&](int column, int row) {
    return cubeDirection(orientation, row / size, (column + 0.5) / size, (row % size + 0.5) / size);
  });
}

Map latlongOf(const Light& light, const Orientation& orientation, int height) {
  const int width = 2 * height;
  return render(light, width, height, [&](int column, int row) {
    return latlongDirection(orientation, (column + 0.5) / width, (row + 0.5) / height);
  });
}

Map renderCube(const WelkinSky* sky, const WelkinSkySample& sample, const Orientation& orientation, int size) {
  return cubeOf(domeOf(sky, sample), orientation, size);
}

Map renderLatlong(const WelkinSky* sky, const WelkinSkySample& sample, const Orientation& orientation, int height) {
  return latlongOf(domeOf(sky, sample), orientation, height);
}

Map nextMip(const Map& cube) {
  const int size = cube.width / 2;
  Map mip = emptyMap(size, 6 * size);
  for (int row = 0; row < mip.height; ++row)
    for (int column = 0; column < size; ++column) {
      const int above = row / size * cube.width + row % size * 2;  // the face's first row, and the row in it
      const std::size_t first = indexOf(cube, 2 * column, above);
      const std::size_t second = indexOf(cube, 2 * column, above + 1);
      for (std::size_t c = 0; c < 3; ++c) {
        const double sum = double{cube.rgb[first + c]} + double{cube.rgb[first + 3 + c]} +
                           double{cube.rgb[second + c]} + double{cube.rgb[second + 3 + c]};
        mip.rgb[indexOf(mip, column, row) + c] = static_cast<float>(0.25 * sum);
      }
    }
  return mip;
}

Map faceOf(const Map& cube, int face) {
  const auto at = [&](int row) { return cube.rgb.begin() + static_cast<std::ptrdiff_t>(indexOf(cube, 0, row)); };
  return {cube.width, cube.width, {at(face * cube.width), at((face + 1) * cube.width)}};
}

}  // namespace welkin::maps
