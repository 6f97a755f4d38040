// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_still_errors.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "sky/cubemap/day_bends.h"

namespace welkin::cubemap {
namespace {

constexpr int kEncodingSize = 64;  // rounding does not depend on the size: measured at one
constexpr int kEven = 32;          // hours beside the bends

}  // namespace

CubemapStillErrors::CubemapStillErrors(const model::Sky& sky, int largest_size, const base::Progress& progress)
    : time_h_(bendsOf(sky)) {
  for (int i = 0; i < kEven; ++i) time_h_.push_back(format::kDay_h * i / kEven);
  tidyHours(time_h_);
  const auto partsOf = [&](int size, format::CubemapFormat format) {
    return partsAt(sky, {size, format, time_h_, {}}, progress);
  };
  for (int size = kSmallestCubemap; size <= largest_size; size *= 2) {
    std::vector<double>& value = resolution_.emplace_back();
    for (const auto& parts : partsOf(size, format::CubemapFormat::rgba16f)) value.push_back(parts.resolution);
  }
  for (const format::CubemapFormat format : kPlannedFormats) {
    std::vector<double>& value = encoding_.emplace_back();
    for (const auto& parts : partsOf(kEncodingSize, format)) value.push_back(parts.encoding);
  }
}

double CubemapStillErrors::at(int size, format::CubemapFormat format, double time_h) const {
  const format::KeySegment segment = format::findSegment(time_h_, time_h);
  const auto larger = [&](const std::vector<double>& value) {
    return std::max(value[segment.first], value[segment.second]);
  };
  const auto doublings = std::bit_width(static_cast<unsigned>(size / kSmallestCubemap)) - 1;
  const double resolution = larger(resolution_[static_cast<std::size_t>(doublings)]);
  const double encoding = larger(encoding_[static_cast<std::size_t>(format)]);
  return std::sqrt(resolution * resolution + encoding * encoding);
}

}  // namespace welkin::cubemap
