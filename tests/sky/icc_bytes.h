// SPDX-License-Identifier: Apache-2.0
// ICC profiles for tests (ICC.1:2022): a display's, with a matrix and curves, or grey.
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "png_bytes.h"

namespace welkin::tests {

inline std::string fixed16(double v) {
  return bigEndian(static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(v * 65536.0))));
}

/// `space` is "RGB " or "GRAY", `tags` the names and data of the tags.
inline std::string iccOf(const std::string& space, const std::vector<std::pair<std::string, std::string>>& tags) {
  std::string table = bigEndian(static_cast<std::uint32_t>(tags.size())), data;
  const std::size_t start = 128 + 4 + 12 * tags.size();
  for (const auto& [name, bytes] : tags) {
    table += name + bigEndian(static_cast<std::uint32_t>(start + data.size())) +
             bigEndian(static_cast<std::uint32_t>(bytes.size()));
    data += bytes + std::string((4 - bytes.size() % 4) % 4, '\0');
  }
  const std::string white = fixed16(0.9642) + fixed16(1.0) + fixed16(0.8249);
  std::string header = bigEndian(static_cast<std::uint32_t>(start + data.size())) + std::string(4, '\0') +
                       std::string("\x02\x10\0\0", 4) + "mntr" + space + "XYZ " + std::string(12, '\0') + "acsp" +
                       std::string(24, '\0') + bigEndian(0) + white;
  header.resize(128, '\0');
  return header + table + data;
}

inline std::string xyzTag(double x, double y, double z) {
  return "XYZ " + bigEndian(0) + fixed16(x) + fixed16(y) + fixed16(z);
}
inline std::string gammaTag(double gamma) {
  return "curv" + bigEndian(0) + bigEndian(1) + bigEndian(static_cast<std::uint32_t>(std::lround(gamma * 256.0)), 2);
}
inline std::string tableTag(const std::vector<double>& values) {
  std::string text = "curv" + bigEndian(0) + bigEndian(static_cast<std::uint32_t>(values.size()));
  for (const double v : values) text += bigEndian(static_cast<std::uint32_t>(std::lround(v * 65535.0)), 2);
  return text;
}
inline std::string parametricTag(int type, const std::vector<double>& values) {
  std::string text = "para" + bigEndian(0) + bigEndian(static_cast<std::uint32_t>(type), 2) + std::string(2, '\0');
  for (const double v : values) text += fixed16(v);
  return text;
}

/// Rec. 709's primaries adapted to D50 by Bradford's method, as sRGB profiles have them, and one curve.
inline std::string rgbProfile(const std::string& curve, bool swapped = false) {
  const std::string red = xyzTag(0.43607, 0.22249, 0.01392), green = xyzTag(0.38515, 0.71687, 0.09708);
  return iccOf("RGB ", {{"rXYZ", swapped ? green : red},
                        {"gXYZ", swapped ? red : green},
                        {"bXYZ", xyzTag(0.14307, 0.06061, 0.71410)},
                        {"rTRC", curve},
                        {"gTRC", curve},
                        {"bTRC", curve}});
}

}  // namespace welkin::tests
