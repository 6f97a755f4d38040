// SPDX-License-Identifier: Apache-2.0
// Fuzz target: the bytes of a cubemap or latlong picture for projection into spherical harmonics.
#include <algorithm>

#include "fuzz.h"
#include "sky/cubemap/environment.h"
#include "sky/image/image_module.h"

/// Loads the module before the time of an input counts.
extern "C" int LLVMFuzzerInitialize(int*, char***) {
  welkin::image::imageModule();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  using namespace welkin;
  constexpr int kBands = 3;
  static const fuzz::Folder kFolder;
  const auto path = kFolder.write("environment", {bytes, size});
  cubemap::Environment environment;
  if (!fuzz::accepts([&] { environment = cubemap::projectImage(path, kBands); })) return 0;
  fuzz::require(!environment.layout.empty() && environment.width >= 1 && environment.height >= 1, "a layout is named");
  fuzz::require(environment.radiance_sh.size() == kBands * kBands, "every coefficient is there");
  fuzz::require(std::all_of(environment.radiance_sh.begin(), environment.radiance_sh.end(),
                            [](const auto& c) { return fuzz::isFinite(c); }),
                "the coefficients are finite");
  return 0;
}
