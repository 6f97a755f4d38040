// SPDX-License-Identifier: Apache-2.0
#include "command/arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "sky/base/error.h"

namespace welkin::command {
namespace {

/// Parses `text` as a finite number; nothing if any part of it is not a number.
std::optional<double> parseNumber(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

std::optional<std::vector<double>> parseNumbers(std::string_view text) {
  std::vector<double> numbers;
  for (;;) {
    const std::size_t comma = text.find(',');
    const auto number = parseNumber(text.substr(0, comma));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    text.remove_prefix(comma + 1);
  }
}

f64::Number3 parsePosition(const std::string& option, const std::string& text) {
  const auto v = parseNumbers(text);
  if (!v || v->size() != 3)
    throw base::Error(base::ExitStatus::usage,
                      fmt::format("{}: \"{}\" is not a position: three finite numbers X,Y,Z in metres", option, text));
  return {(*v)[0], (*v)[1], (*v)[2]};
}

f64::Number3 parseDirection(const std::string& option, const std::string& text) {
  const auto refuse = [&] {
    return base::Error(
        base::ExitStatus::usage,
        fmt::format("{}: \"{}\" is not a direction: three finite numbers X,Y,Z that are not all zero", option, text));
  };
  const auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 3) throw refuse();
  f64::Number3 v((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  if (!(largest > 0.0)) throw refuse();
  v = v / largest;  // the square of a huge or tiny component leaves double's range
  return v / std::sqrt(dot(v, v));
}

double parseTime(const std::string& text) {
  const auto time = parseNumber(text);
  if (!time)
    throw base::Error(base::ExitStatus::usage, fmt::format("--time: \"{}\" is not a finite number of hours", text));
  return *time;
}

std::vector<std::string> joinSignedValues(int argc, char** argv) {
  std::vector<std::string> joined;
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const bool takes_numbers = argument == "--time" || argument == "--direction" || argument == "--normal" ||
                               argument == "--position" || argument == "--camera" || argument == "--light";
    if (takes_numbers && i + 1 < argc && argv[i + 1][0] == '-' && argv[i + 1][1] != '-')
      joined.push_back(argument + "=" + argv[++i]);
    else
      joined.push_back(argument);
  }
  return joined;
}

nlohmann::ordered_json vectorJson(const float v[3]) {
  return {double{v[0]}, double{v[1]}, double{v[2]}};
}

double azimuthDegrees(const float d[3]) {
  const double azimuth = std::atan2(double{d[0]}, -double{d[2]}) / f64::kDegree;
  return azimuth < 0.0 ? azimuth + 360.0 : azimuth;
}

double elevationDegrees(const float d[3]) {
  return f64::elevationOf({double{d[0]}, double{d[1]}, double{d[2]}}) / f64::kDegree;
}

nlohmann::ordered_json lightJson(const WelkinLight& light) {
  return {{"azimuth_deg", azimuthDegrees(light.direction)},
          {"elevation_deg", elevationDegrees(light.direction)},
          {"direction", vectorJson(light.direction)},
          {"illuminance", double{light.illuminance}},
          {"colour", vectorJson(light.colour)},
          {"normal_irradiance", vectorJson(light.normal_irradiance)}};
}

nlohmann::ordered_json coefficientsJson(const float (*sh)[3], std::uint32_t count) {
  nlohmann::ordered_json channels = {
      {"r", nlohmann::json::array()}, {"g", nlohmann::json::array()}, {"b", nlohmann::json::array()}};
  for (std::uint32_t i = 0; i < count; ++i) {
    channels["r"].push_back(double{sh[i][0]});
    channels["g"].push_back(double{sh[i][1]});
    channels["b"].push_back(double{sh[i][2]});
  }
  return channels;
}

}  // namespace welkin::command
