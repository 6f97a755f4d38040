// SPDX-License-Identifier: Apache-2.0
// Sky files for tests: short texts whose light has a closed form.
#pragma once

#include <string>

namespace welkin::tests {

/// A sun that stands still, without light of its own.
inline const std::string kStillSun = "path = [[0, 0, 60]]";

/// The text of a sky file from the keys of its sections.
inline std::string skyText(const std::string& sky, const std::string& sun = kStillSun,
                           const std::string& bake = "keys = 2\ncubemap_size = 0") {
  return "[sky]\n" + sky + "\n[sun]\n" + sun + "\n[bake]\n" + bake + "\n";
}

/// Radiance 1 everywhere above the horizon: CIE type 5 has no gradation and no indicatrix.
inline const std::string kUniform = "luminance = \"cie-5\"\nnormalise = \"zenith\"";

}  // namespace welkin::tests
