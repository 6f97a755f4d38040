// SPDX-License-Identifier: Apache-2.0
// A calibration without its photograph: saved as JSON and used on other photographs of the same camera and light.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "calibrate/photo.h"

namespace welkin::calibrate {

struct Profile {
  Model model;
  bool linear_codes = false;          ///< how photographs are read: Encoding::linear, else Encoding::srgb
  Colour brightest = Colour::Zero();  ///< linear, of every channel over the chart's used patches; above 0
  std::string photo;                  ///< hash of the chart's photograph; empty if the file does not tell
};

Profile profileOf(const CalibratedPhoto& photo);

nlohmann::ordered_json profileJson(const Profile& profile);

/// Reads what profileJson() makes. Throws Error(file), and Error(content) naming file and key for another form, a model
/// that there is not, a number that is not finite or past 1e6, and numbers that give no finite colour.
Profile readProfile(const std::filesystem::path& path);

/// Part of the texels with a channel above the chart's brightest: there the model is a guess from darker colours.
double partPastChart(const image::Image& image, const Profile& profile);

/// A part past the chart that is worth a warning: one texel in a hundred.
inline constexpr double kMuchPastChart = 0.01;

}  // namespace welkin::calibrate
