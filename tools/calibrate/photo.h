// SPDX-License-Identifier: Apache-2.0
// A photograph that holds a chart: read, searched and calibrated.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "calibrate/calibration.h"
#include "calibrate/other_chart.h"
#include "calibrate/uneven_light.h"
#include "sky/image/image.h"

namespace welkin::calibrate {

/// What the codes of a photograph mean.
enum class Encoding {
  choose,  ///< `srgb` or `linear`, by the smaller mean CIEDE2000 left out
  srgb,    ///< what the file says: a profile, a gamma, or else sRGB's curve
  linear   ///< light itself, as from a camera without a curve; what the file says of a curve does not count
};

struct PhotoOptions {
  Encoding encoding = Encoding::choose;
  std::optional<Corners> corners;  ///< of the chart, from dark skin's on; else it is searched
  std::string model = "auto";
  bool flatten = false;  ///< whether a gradient of light over the chart is taken out of its patches
  ReferenceChart reference;
};

struct CalibratedPhoto {
  image::Image image;  ///< as photographed, linear
  bool linear_codes = false;
  std::vector<FoundChart> charts;      ///< at least one; the most likely first
  Calibration calibration;             ///< by the first chart
  std::optional<LightGradient> light;  ///< taken out of the first chart's patches
  std::vector<ChartError> others;      ///< of the calibration on the further charts
  std::string hash;                    ///< of the file's bytes
  std::vector<std::string> warnings;
};

/// At most 67 million pixels, of 12 bytes each in memory; twice that while two encodings are tried.
inline constexpr image::ImageLimits kPhotoLimits{32768, std::size_t{1} << 26, false};

/// Throws Error(file), and Error(content) with the reason where there is no chart to trust.
CalibratedPhoto calibratePhoto(const std::filesystem::path& path, const PhotoOptions& options);

/// Linear Rec. 709 albedo of every texel: the model's colour, no channel below 0.
image::Image albedoOf(const image::Image& image, const Model& model);

}  // namespace welkin::calibrate
