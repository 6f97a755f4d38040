// SPDX-License-Identifier: Apache-2.0
#include "tests/runtime/small_file.h"

#include "sky/bake/encode.h"

namespace welkin::tests {

const std::vector<std::byte>& smallFile() {
  static const std::vector<std::byte> kBytes = [] {
    bake::SkyFile file;
    file.sky.sun.path.key_time_h = {0.0};
    file.sky.sun.path.key_azimuth_rad = {0.0};
    file.sky.sun.path.key_elevation_rad = {0.5};
    file.sky.moon = file.sky.sun;
    file.settings = "{}";
    file.bake.key_time_h = {0.0, 12.0};
    file.bake.cubemap_size = 2;
    file.bake.cubemap_time_h = {6.0, 18.0};
    const model::SkyInstant instant(file.sky, 0.0);
    const auto image = cubemap::renderCubemap(instant, det::Number3(0.1), 2, format::CubemapFormat::rgba16f);
    return bake::encodeSky(file, table::bakeDayTable(file.sky, 2, file.bake.key_time_h, {}), {image, image});
  }();
  return kBytes;
}

}  // namespace welkin::tests
