// SPDX-License-Identifier: Apache-2.0
// Values of the command line and of the results printed for it.
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

/// "X,Y,Z" as a unit vector. Throws Error(usage) for anything but three finite numbers that are not all zero.
f64::Number3 parseDirection(const std::string& option, const std::string& text);

/// Three finite numbers "X,Y,Z", metres. Throws Error(usage).
f64::Number3 parsePosition(const std::string& option, const std::string& text);

/// The finite numbers that the text lists with commas between; nothing where it is anything else.
std::optional<std::vector<double>> parseNumbers(std::string_view text);

/// A finite number of hours. Throws Error(usage).
double parseTime(const std::string& text);

/// Joins the options that take numbers to a value that starts with a sign, so that "--normal -.5,1,0" parses.
std::vector<std::string> joinSignedValues(int argc, char** argv);

/// The .welkin file of a path: itself, or DIR/sky.welkin. Throws Error(file) when neither is there.
std::string skyFileOf(const std::string& path);

using bake::require;

nlohmann::ordered_json vectorJson(const float v[3]);
nlohmann::ordered_json lightJson(const WelkinLight& light);
/// {"r": [...], "g": [...], "b": [...]}
nlohmann::ordered_json coefficientsJson(const float (*sh)[3], std::uint32_t count);

/// Degrees, azimuth clockwise from north in [0, 360).
double azimuthDegrees(const float direction[3]);
double elevationDegrees(const float direction[3]);

}  // namespace welkin::command
