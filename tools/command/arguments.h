// SPDX-License-Identifier: Apache-2.0
// Parses values of the command line, and formats values for printing.
#pragma once

#include <welkin/welkin.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "shared.h"
#include "sky/bake/runtime_error.h"

namespace welkin::command {

/// Parses "X,Y,Z" as a unit vector. Throws Error(usage) for anything but three finite numbers that are not all zero.
f64::Number3 parseDirection(const std::string& option, const std::string& text);

/// Parses three finite numbers "X,Y,Z", metres. Throws Error(usage).
f64::Number3 parsePosition(const std::string& option, const std::string& text);

/// Parses a list of finite numbers with commas between them; nothing for any other text.
std::optional<std::vector<double>> parseNumbers(std::string_view text);

/// Parses a finite number of hours. Throws Error(usage).
double parseTime(const std::string& text);

/// Arguments with "=" between a number option and a value that starts with a sign, so that "--normal -.5,1,0" parses.
std::vector<std::string> joinSignedValues(int argc, char** argv);

using bake::require;

nlohmann::ordered_json vectorJson(const float v[3]);
nlohmann::ordered_json lightJson(const WelkinLight& light);
/// {"r": [...], "g": [...], "b": [...]}
nlohmann::ordered_json coefficientsJson(const float (*sh)[3], std::uint32_t count);

/// Azimuth of a direction in degrees, clockwise from north, in [0, 360).
double azimuthDegrees(const float direction[3]);
double elevationDegrees(const float direction[3]);

}  // namespace welkin::command
