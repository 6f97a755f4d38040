// SPDX-License-Identifier: Apache-2.0
#include "probes/transfer/encoding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "probes/transfer/fixed_point.h"
#include "sky/base/error.h"

namespace welkin::transfer {
namespace {

constexpr std::size_t kUp = 3;                     ///< directions that see the sky
constexpr std::size_t kColours = kDirections * 3;  ///< colour components per probe
constexpr std::size_t kSky = 2 * kColours;         ///< numbers of coefficients 0 and 1; 2 and 3 have as many
constexpr double kLargest = 3e38;
constexpr double kMostSun = 1e6;  ///< far above the irradiance that a light of normal irradiance 1 can give

[[noreturn]] void refuse(geometry::SectorId id, std::size_t probe, const std::string& what) {
  throw base::Error(base::ExitStatus::content, fmt::format("sector {}_{}: probe {}: {}", id.x, id.z, probe, what));
}

/// Checks a probe's numbers of one kind against their range.
class Checked {
 public:
  Checked(geometry::SectorId id, std::size_t probe) : id_(id), probe_(probe) {}
  void of(double value, const char* what, double low = -kLargest, double high = kLargest) const {
    if (!(value >= low && value <= high))
      refuse(id_, probe_, fmt::format("{}: {}; allowed: {} to {}", what, value, low, high));
  }

 private:
  geometry::SectorId id_;
  std::size_t probe_;
};

/// The numbers of coefficient `first` and the next one: [direction][coefficient][channel].
template <typename Transfer>
decltype(auto) skyNumber(Transfer& t, std::size_t first, std::size_t i) {
  return t.sky[i / 6][first + i / 3 % 2][static_cast<int>(i % 3)];
}

std::array<double, kSky> skyNumbers(const ProbeTransfer& t, std::size_t first) {
  std::array<double, kSky> number;
  for (std::size_t i = 0; i < kSky; ++i) number[i] = skyNumber(t, first, i);
  return number;
}

std::array<double, kColours> emittedNumbers(const ProbeTransfer& t) {
  std::array<double, kColours> number;
  for (std::size_t i = 0; i < kColours; ++i) number[i] = t.emitted[i / 3][static_cast<int>(i % 3)];
  return number;
}

double largestOf(std::span<const double> number) {
  double largest = 0.0;
  for (const double x : number) largest = std::max(largest, std::abs(x));
  return largest;
}

template <typename Integer>
void append(std::span<const double> number, double scale, std::vector<Integer>& steps) {
  for (const double x : number) steps.push_back(toFixed<Integer>(x, scale));
}

/// Appends a scale and the numbers relative to it.
template <typename Integer>
void append(std::span<const double> number, std::vector<std::uint16_t>& scales, std::vector<Integer>& steps) {
  scales.push_back(scaleFor(largestOf(number)));
  append(number, scaleOf(scales.back()), steps);
}

void encodeSky(const ProbeTransfer& t, EncodedProbes& encoded) {
  const auto sky = skyNumbers(t, 0);
  const auto side = skyNumbers(t, 2);
  encoded.sky_scale.push_back(scaleFor(std::max(largestOf(sky), largestOf(side))));
  const double scale = scaleOf(encoded.sky_scale.back());
  append(sky, scale, encoded.sky);
  append(side, scale, encoded.sky_side);
}

double largestOf(std::span<const Number3> colours) {
  double largest = 0.0;
  for (const Number3& x : colours) largest = std::max({largest, std::abs(x.x), std::abs(x.y), std::abs(x.z)});
  return largest;
}

void encodeModes(const SectorProbes& probes, EncodedProbes& encoded) {
  const SunModes& modes = probes.modes;
  for (const double time : modes.sun_time_h) encoded.sun_time_h.push_back(static_cast<float>(time));
  for (const double time : modes.moon_time_h) encoded.moon_time_h.push_back(static_cast<float>(time));
  const std::size_t knots = modes.knots();
  for (std::size_t m = 0; m < modes.count(); ++m) {
    const auto row = std::span(modes.value).subspan(m * knots, knots);
    const double scale = scaleOf(scaleFor(largestOf(row)));
    encoded.mode_scale.push_back(static_cast<float>(scale));
    for (const Number3& x : row)
      for (int c = 0; c < 3; ++c) encoded.mode.push_back(toFixed<std::int8_t>(x[c], scale));
    double coefficient = 0.0;
    for (const SunCoefficients& sun : probes.sun)
      for (const auto& direction : sun) coefficient = std::max(coefficient, std::abs(direction[m]));
    encoded.coefficient_scale.push_back(static_cast<float>(scaleOf(scaleFor(coefficient))));
  }
}

/// Encodes a probe's coefficients relative to the modes' scales.
void encodeSun(const SunCoefficients& sun, EncodedProbes& encoded) {
  if (encoded.modes() == 0) return;
  std::vector<double> number;
  for (const auto& direction : sun)
    for (std::size_t m = 0; m < direction.size(); ++m) {
      const double scale = double{encoded.coefficient_scale[m]};
      number.push_back(scale > 0.0 ? direction[m] / scale : 0.0);
    }
  append<std::int8_t>(number, encoded.sun_scale, encoded.sun);
}

/// Sets the lowest and highest height, as floats that enclose all positions.
void setHeights(const std::vector<Number3>& position, EncodedProbes& encoded) {
  if (position.empty()) return;
  const auto [low, high] = std::minmax_element(position.begin(), position.end(),
                                               [](const Number3& a, const Number3& b) { return a.y < b.y; });
  encoded.low_y = static_cast<float>(low->y);
  encoded.high_y = static_cast<float>(high->y);
  if (double{encoded.low_y} > low->y) encoded.low_y = std::nextafter(encoded.low_y, -std::numeric_limits<float>::max());
  if (double{encoded.high_y} < high->y)
    encoded.high_y = std::nextafter(encoded.high_y, std::numeric_limits<float>::max());
}

template <typename T>
std::size_t bytesOf(const std::vector<T>& array) {
  return array.size() * sizeof(T);
}

}  // namespace

ProbeBytes EncodedProbes::bytes() const {
  ProbeBytes bytes;
  bytes.position = bytesOf(position);
  bytes.visibility = bytesOf(visibility);
  bytes.sky = bytesOf(sky) + bytesOf(sky_side);
  bytes.sun = bytesOf(sun);
  bytes.emitted = bytesOf(emitted);
  bytes.scales = bytesOf(sky_scale) + bytesOf(sun_scale) + bytesOf(emitted_scale);
  bytes.heights = sizeof low_y + sizeof high_y;
  bytes.modes =
      bytesOf(sun_time_h) + bytesOf(moon_time_h) + bytesOf(coefficient_scale) + bytesOf(mode_scale) + bytesOf(mode);
  return bytes;
}

EncodedProbes encodeProbes(const SectorProbes& probes) {
  EncodedProbes encoded;
  const Number3 corner(geometry::kSector_m * probes.id.x, 0.0, geometry::kSector_m * probes.id.z);
  for (std::size_t i = 0; i < probes.position.size(); ++i) {
    const Checked checked(probes.id, i);
    checked.of(probes.position[i].x - corner.x, "x from the sector's corner", 0.0, geometry::kSector_m);
    checked.of(probes.position[i].z - corner.z, "z from the sector's corner", 0.0, geometry::kSector_m);
    checked.of(probes.position[i].y, "y", -1e6, 1e6);
    const ProbeTransfer& t = probes.transfer[i];
    for (std::size_t b = 0; b < kDirections; ++b) checked.of(t.visibility[b], "visibility", 0.0, b < kUp ? 1.0 : 0.0);
    for (const double x : skyNumbers(t, 0)) checked.of(x, "transfer of the sky", 0.0);
    for (const double x : skyNumbers(t, 2)) checked.of(x, "transfer of the sky");
    for (std::size_t b = 0; b < kDirections; ++b) {
      for (int c = 0; c < 3; ++c) checked.of(t.emitted[b][c], "emitted light", 0.0);
      for (const double coefficient : probes.sun[i][b])
        checked.of(coefficient, "transfer of the sun", -kMostSun, kMostSun);
    }
  }
  setHeights(probes.position, encoded);
  const double low = double{encoded.low_y};
  const double height = double{encoded.high_y} - low;
  const bool emissive = std::any_of(probes.transfer.begin(), probes.transfer.end(), [](const ProbeTransfer& t) {
    return std::any_of(t.emitted.begin(), t.emitted.end(), [](const Number3& e) { return !(e == Number3(0.0)); });
  });
  encodeModes(probes, encoded);
  for (std::size_t i = 0; i < probes.position.size(); ++i) {
    const ProbeTransfer& t = probes.transfer[i];
    const Number3 place = probes.position[i] - corner;
    encoded.position.push_back(toFixed<std::uint16_t>(place.x, geometry::kSector_m));
    encoded.position.push_back(toFixed<std::uint16_t>(place.y - low, height));
    encoded.position.push_back(toFixed<std::uint16_t>(place.z, geometry::kSector_m));
    for (std::size_t b = 0; b < kUp; ++b) encoded.visibility.push_back(toFixed<std::uint16_t>(t.visibility[b], 1.0));
    encodeSky(t, encoded);
    encodeSun(probes.sun[i], encoded);
    if (emissive) append<std::uint8_t>(emittedNumbers(t), encoded.emitted_scale, encoded.emitted);
  }
  return encoded;
}

SectorProbes decodedProbes(const EncodedProbes& e, geometry::SectorId id) {
  const std::size_t n = e.probes();
  const std::size_t modes = e.modes();
  const std::size_t knots = e.sun_time_h.size() + e.moon_time_h.size();
  const bool emissive = !e.emitted_scale.empty();
  if (e.position.size() != n * 3 || e.visibility.size() != n * kUp || e.sky.size() != n * kSky ||
      e.sky_side.size() != n * kSky || e.sun_scale.size() != (modes > 0 ? n : 0) ||
      e.sun.size() != n * modes * kDirections || e.coefficient_scale.size() != modes ||
      e.mode.size() != modes * knots * 3 || (emissive && e.emitted_scale.size() != n) ||
      e.emitted.size() != (emissive ? n * kColours : 0))
    throw base::Error(base::ExitStatus::content,
                      fmt::format("sector {}_{}: its arrays do not fit each other", id.x, id.z));
  SectorProbes probes;
  probes.id = id;
  probes.modes.sun_time_h.assign(e.sun_time_h.begin(), e.sun_time_h.end());
  probes.modes.moon_time_h.assign(e.moon_time_h.begin(), e.moon_time_h.end());
  for (std::size_t i = 0; i < e.mode.size(); i += 3) {
    const double scale = double{e.mode_scale[i / (3 * knots)]};
    probes.modes.value.emplace_back(fromFixed(e.mode[i], scale), fromFixed(e.mode[i + 1], scale),
                                    fromFixed(e.mode[i + 2], scale));
  }
  const double low = double{e.low_y};
  const double height = double{e.high_y} - low;
  for (std::size_t i = 0; i < n; ++i) {
    probes.position.emplace_back(geometry::kSector_m * id.x + fromFixed(e.position[3 * i], geometry::kSector_m),
                                 low + fromFixed(e.position[3 * i + 1], height),
                                 geometry::kSector_m * id.z + fromFixed(e.position[3 * i + 2], geometry::kSector_m));
    ProbeTransfer& t = probes.transfer.emplace_back();
    SunCoefficients& sun = probes.sun.emplace_back();
    for (std::size_t b = 0; b < kUp; ++b) t.visibility[b] = fromFixed(e.visibility[kUp * i + b], 1.0);
    for (std::size_t j = 0; j < kDirections * modes; ++j)
      sun[j / modes].push_back(fromFixed(e.sun[kDirections * modes * i + j], scaleOf(e.sun_scale[i])) *
                               double{e.coefficient_scale[j % modes]});
    for (std::size_t j = 0; j < kSky; ++j) {
      skyNumber(t, 0, j) = fromFixed(e.sky[kSky * i + j], scaleOf(e.sky_scale[i]));
      skyNumber(t, 2, j) = fromFixed(e.sky_side[kSky * i + j], scaleOf(e.sky_scale[i]));
    }
    for (std::size_t j = 0; emissive && j < kColours; ++j)
      t.emitted[j / 3][static_cast<int>(j % 3)] = fromFixed(e.emitted[kColours * i + j], scaleOf(e.emitted_scale[i]));
  }
  return probes;
}

}  // namespace welkin::transfer
