// SPDX-License-Identifier: Apache-2.0
#include "maps/radiance_hdr.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>

namespace welkin::maps {
namespace {

using Texel = std::array<std::uint8_t, 4>;

constexpr int kBias = 128;  // a component is mantissa / 256 * 2^(exponent - 128)
constexpr double kLargest = 255.0 / 256.0 * 0x1p127;
constexpr int kFewestColumns = 8, kMostColumns = 32767;  // of a line that may be run-length encoded

Texel texelOf(const float* rgb, std::size_t& saturated) {
  double component[3];
  for (std::size_t c = 0; c < 3; ++c) {
    saturated += double{rgb[c]} > kLargest ? 1U : 0U;
    component[c] = std::clamp(double{rgb[c]}, 0.0, kLargest);
  }
  const double largest = *std::max_element(component, component + 3);
  if (!(largest >= 1e-38)) return {};
  int exponent;
  std::frexp(largest, &exponent);
  if (std::floor(std::ldexp(largest, 8 - exponent) + 0.5) > 255.0) ++exponent;  // 255.5 and above become 128
  Texel texel;
  for (std::size_t c = 0; c < 3; ++c)
    texel[c] = static_cast<std::uint8_t>(std::floor(std::ldexp(component[c], 8 - exponent) + 0.5));
  texel[3] = static_cast<std::uint8_t>(exponent + kBias);
  return texel;
}

/// Appends one component of a line: a byte above 128 announces a run of one value, another byte as many values.
void appendRuns(const std::vector<std::uint8_t>& line, std::vector<std::byte>& bytes) {
  constexpr std::size_t kShortestRun = 4, kLongestRun = 127, kMostLiterals = 128;
  const auto runAt = [&](std::size_t at) {
    std::size_t end = at + 1;
    while (end < line.size() && end - at < kLongestRun && line[end] == line[at]) ++end;
    return end - at;
  };
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t run = runAt(at);
    if (run >= kShortestRun) {
      bytes.push_back(static_cast<std::byte>(128 + run));
      bytes.push_back(static_cast<std::byte>(line[at]));
      at += run;
      continue;
    }
    std::size_t end = at + run;
    while (end < line.size() && runAt(end) < kShortestRun) end += runAt(end);
    end = std::min(end, at + kMostLiterals);
    bytes.push_back(static_cast<std::byte>(end - at));
    for (; at < end; ++at) bytes.push_back(static_cast<std::byte>(line[at]));
  }
}

void appendLine(const std::vector<Texel>& texels, std::vector<std::byte>& bytes) {
  const auto columns = static_cast<int>(texels.size());
  if (columns < kFewestColumns || columns > kMostColumns) {
    for (const Texel& texel : texels)
      for (const std::uint8_t byte : texel) bytes.push_back(static_cast<std::byte>(byte));
    return;
  }
  for (const int byte : {2, 2, columns >> 8, columns & 255}) bytes.push_back(static_cast<std::byte>(byte));
  std::vector<std::uint8_t> line(texels.size());
  for (std::size_t c = 0; c < 4; ++c) {
    for (std::size_t i = 0; i < texels.size(); ++i) line[i] = texels[i][c];
    appendRuns(line, bytes);
  }
}

}  // namespace

RadianceFile encodeRadiance(const Map& map) {
  RadianceFile file;
  const std::string header =
      "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nPRIMARIES=0.64 0.33 0.30 0.60 0.15 0.06 0.3127 0.3290\n\n-Y " +
      std::to_string(map.height) + " +X " + std::to_string(map.width) + "\n";
  for (const char c : header) file.bytes.push_back(static_cast<std::byte>(c));
  std::vector<Texel> line(static_cast<std::size_t>(map.width));
  const float* rgb = map.rgb.data();
  for (int row = 0; row < map.height; ++row) {
    for (Texel& texel : line) {
      texel = texelOf(rgb, file.saturated);
      rgb += 3;
    }
    appendLine(line, file.bytes);
  }
  return file;
}

}  // namespace welkin::maps
