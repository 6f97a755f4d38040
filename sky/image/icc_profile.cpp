// SPDX-License-Identifier: Apache-2.0
#include "sky/image/icc_profile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "sh/deterministic.h"
#include "sky/base/error.h"
#include "sky/image/colour.h"

namespace welkin::image {

using det::Number3;
namespace {

constexpr std::array<double, 2> kD50 = {0.9642 / 2.7891, 1.0 / 2.7891};  // of the profile connection space

/// A curve from stored values to linear light: a table, or y = (a x + b)^g + e from d on and c x + f below it.
struct Curve {
  std::vector<double> table;
  double g = 1.0, a = 1.0, b = 0.0, c = 0.0, d = 0.0, e = 0.0, f = 0.0;

  double at(double x) const {
    if (!table.empty()) {
      const double place = std::clamp(x, 0.0, 1.0) * static_cast<double>(table.size() - 1);
      const auto i = std::min(static_cast<std::size_t>(place), table.size() - 2);
      return table[i] + (table[i + 1] - table[i]) * (place - static_cast<double>(i));
    }
    if (x < d) return c * x + f;
    const double base = a * x + b;
    return (base > 0.0 ? det::pow(base, g) : 0.0) + e;
  }
};

class Profile {
 public:
  Profile(const std::string& name, std::span<const std::byte> bytes) : name_(name), bytes_(bytes) {}

  base::Error refusal(const std::string& why) const {
    return {base::ExitStatus::content, fmt::format("{}: ICC profile: {}", name_, why)};
  }
  std::uint32_t u32(std::size_t at) const {
    require(at, 4);
    return byte(at) << 24U | byte(at + 1) << 16U | byte(at + 2) << 8U | byte(at + 3);
  }
  std::uint32_t u16(std::size_t at) const {
    require(at, 2);
    return byte(at) << 8U | byte(at + 1);
  }
  double fixed(std::size_t at) const { return static_cast<std::int32_t>(u32(at)) / 65536.0; }
  std::string text(std::size_t at) const {
    require(at, 4);
    return {reinterpret_cast<const char*>(bytes_.data()) + at, 4};
  }

  /// Place of a tag's data.
  std::optional<std::size_t> tag(std::string_view signature) const {
    const std::size_t count = u32(128);
    if (count > 1000) throw refusal("damaged: more than 1000 tags");
    for (std::size_t i = 0; i < count; ++i)
      if (text(132 + 12 * i) == signature) return u32(132 + 12 * i + 4);
    return std::nullopt;
  }
  Number3 xyz(std::string_view signature) const {
    const std::size_t at = needed(signature);
    if (text(at) != "XYZ ") throw refusal(fmt::format("damaged: {} is not XYZ", signature));
    return {fixed(at + 8), fixed(at + 12), fixed(at + 16)};
  }
  Curve curve(std::string_view signature) const;

 private:
  std::uint32_t byte(std::size_t at) const { return static_cast<std::uint8_t>(bytes_[at]); }
  void require(std::size_t at, std::size_t count) const {
    if (at > bytes_.size() || count > bytes_.size() - at) throw refusal("damaged or cut");
  }
  std::size_t needed(std::string_view signature) const {
    const auto at = tag(signature);
    if (!at) throw refusal(fmt::format("{} is missing", signature));
    return *at;
  }

  const std::string& name_;
  std::span<const std::byte> bytes_;
};

Curve Profile::curve(std::string_view signature) const {
  const std::size_t at = needed(signature);
  Curve curve;
  if (text(at) == "curv") {
    const std::size_t count = u32(at + 8);
    if (count == 0) return curve;
    require(at + 12, 2 * count);
    if (count == 1) {
      curve.g = u16(at + 12) / 256.0;
      return curve;
    }
    for (std::size_t i = 0; i < count; ++i) curve.table.push_back(u16(at + 12 + 2 * i) / 65535.0);
    return curve;
  }
  if (text(at) != "para") throw refusal(fmt::format("{} is no curve", signature));
  const std::uint32_t type = u16(at + 8);
  if (type > 4) throw refusal(fmt::format("{} is a curve of type {}; 0 to 4 are allowed", signature, type));
  const auto value = [&](std::size_t i) { return fixed(at + 12 + 4 * i); };
  curve.g = value(0);
  if (type == 0) return curve;
  curve.a = value(1);
  curve.b = value(2);
  if (type <= 2) {  // 0 (type 1) or the constant (type 2) below -b / a
    if (!(curve.a > 0.0)) throw refusal(fmt::format("{} does not rise", signature));
    curve.d = -curve.b / curve.a;
    if (type == 2) curve.e = curve.f = value(3);
    return curve;
  }
  curve.c = value(3);
  curve.d = value(4);
  if (type == 4) {
    curve.e = value(5);
    curve.f = value(6);
  }
  return curve;
}

bool isNearIdentity(const ColourMatrix& m) {
  for (std::size_t c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r)
      if (!(std::abs(m.column[c][r] - (static_cast<int>(c) == r ? 1.0 : 0.0)) <= 1e-3)) return false;
  return true;
}

}  // namespace

void applyIccProfile(const std::string& name, std::span<const std::byte> bytes, Image& image) {
  const Profile profile(name, bytes);
  const std::string space = profile.text(16);
  const bool grey = space == "GRAY";
  if (!grey && space != "RGB ") throw profile.refusal("neither RGB nor grey");
  if (profile.text(20) != "XYZ " || (!grey && !profile.tag("rXYZ")))
    throw profile.refusal("a table of colours; a matrix and curves are read");
  std::array<Curve, 3> curve;
  if (grey)
    curve = {profile.curve("kTRC"), profile.curve("kTRC"), profile.curve("kTRC")};
  else
    curve = {profile.curve("rTRC"), profile.curve("gTRC"), profile.curve("bTRC")};
  for (std::size_t i = 0; i < image.rgb.size(); ++i)
    image.rgb[i] = static_cast<float>(curve[i % 3].at(double{image.rgb[i]}));
  if (grey) return;
  const ColourMatrix matrix =
      rec709OfXyz(kD50) * ColourMatrix{{profile.xyz("rXYZ"), profile.xyz("gXYZ"), profile.xyz("bXYZ")}};
  if (!isNearIdentity(matrix)) convertColours(matrix, "the ICC profile", image);
}

}  // namespace welkin::image
