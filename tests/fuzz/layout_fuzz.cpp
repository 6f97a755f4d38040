// SPDX-License-Identifier: Apache-2.0
// Fuzz target: a picture for projection in a layout that is asked for. The first byte selects the layout, or six faces
// of this one picture; the second an OpenEXR layer.
#include <algorithm>
#include <array>
#include <iterator>

#include "fuzz.h"
#include "sky/cubemap/environment.h"
#include "sky/image/image_module.h"

namespace {

constexpr int kBands = 3;
constexpr const char* kFaces = "faces";
constexpr const char* kLayouts[] = {
    "",       "latlong",     "exr-latlong", "vstrip", "hstrip",      "exr-cube",
    "hcross", "hcross:-z+x", "hcross:+x-z", "vcross", "vcross:-z+x", "vcross:+z-x:upright",
    kFaces};
constexpr const char* kLayers[] = {"", "", "", "Combined", "V.Combined", "left"};

}  // namespace

/// Loads the module before the time of an input counts.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  welkin::image::imageModule();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  static const fuzz::Folder kFolder;
  if (size < 2) return 0;
  const std::string layout = kLayouts[bytes[0] % std::size(kLayouts)], layer = kLayers[bytes[1] % std::size(kLayers)];
  const auto path = kFolder.write("layout", {bytes + 2, size - 2});
  std::array<std::filesystem::path, 6> faces;
  faces.fill(path);
  cubemap::Environment environment;
  const auto read = [&] {
    environment = layout == kFaces ? cubemap::projectFaces(faces, kBands, layer)
                                   : cubemap::projectImage(path, kBands, {layout, layer});
  };
  if (!fuzz::accepts(read)) return 0;
  fuzz::require(!environment.layout.empty() && (layout.empty() || environment.layout == layout), "the layout is named");
  fuzz::require(environment.width >= 1 && environment.height >= 1, "a size is named");
  fuzz::require(environment.radiance_sh.size() == kBands * kBands, "every coefficient is there");
  fuzz::require(std::all_of(environment.radiance_sh.begin(), environment.radiance_sh.end(),
                            [](const auto& c) { return fuzz::isFinite(c); }),
                "the coefficients are finite");
  return 0;
}
