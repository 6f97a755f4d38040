// SPDX-License-Identifier: Apache-2.0
// The options of welkin render and their values; every parser throws Error(usage).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/views.h"
#include "shared.h"

namespace welkin::command {

enum class View { dome, horizon, spheres, sheet, level };

struct RenderOptions {
  std::string sky;
  std::string output;
  std::vector<std::string> times;
  std::string view;  ///< empty: level with a level, else dome for one time, sheet for several
  std::string size;
  std::string source;     ///< empty: analytic
  std::string sky_light;  ///< empty: sh for a level, both for the spheres
  std::string exposure = "auto";
  std::optional<double> yaw_deg;    ///< else the sun's or the moon's azimuth; of a level its middle
  std::optional<double> pitch_deg;  ///< else 18; of a level its middle
  double fov_deg = 60.0;
  bool no_tint = false;
  bool validate = false;
  std::string level;   ///< level.toml
  std::string probes;  ///< the folder of a baked level; empty: none are drawn
  std::string camera;  ///< empty: where the whole level is seen
};

struct Size {
  uint32_t width, height;
};

View parseView(const RenderOptions& options);
WelkinVulkanSource parseSource(const RenderOptions& options);
render::SkyLight parseSkyLight(const RenderOptions& options);
Size parseSize(const RenderOptions& options, Size fallback);
/// Fixed exposure in stops, or nothing for automatic.
std::optional<double> parseExposure(const std::string& text);
/// The camera's position, metres; nothing when none is given.
std::optional<f64::Number3> parseCamera(const RenderOptions& options);

/// Throws for every value that is out of its domain, and for options that do not go together.
void checkOptions(const RenderOptions& options);

}  // namespace welkin::command
