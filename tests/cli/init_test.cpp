// SPDX-License-Identifier: Apache-2.0
// `welkin init` paints the pictures that examples/island keeps.
#include <catch2/catch.hpp>

#include "run_tool.h"
#include "sky/image/image.h"

namespace welkin::tests {

TEST_CASE("Init, PaintsTheIslandsPictures") {
  const Folder folder;
  REQUIRE(runTool({"init", folder / "sky"}).status == 0);
  for (const char* name : {"gradient_sun.png", "gradient_anti.png", "stars.png"}) {
    const auto painted = image::readImage(folder / (std::string("sky/") + name));
    const auto kept = image::readImage(std::string(WELKIN_ISLAND) + "/" + name);
    CAPTURE(name);
    CHECK(painted.width == kept.width);
    CHECK(painted.rgb == kept.rgb);
  }
}

}  // namespace welkin::tests
