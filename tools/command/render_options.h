// SPDX-License-Identifier: Apache-2.0
// The options of welkin render and their values; every parser throws Error(usage).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command/lights_option.h"
#include "command/shared_options.h"
#include "render/views.h"
#include "shared.h"

namespace welkin::command {

enum class View { dome, horizon, spheres, sheet, level };

/// Ambient light of a level, and the part of its light that is drawn.
enum class LevelLight { flat, sh, probes };
enum class Occlusion { none, screen, contact };
enum class Component { all, ambient, sky, sun_bounce, local, occlusion };

/// What a picture of a level shows: the passes' own light, the path tracer's, their difference, or flat light, probes
/// and path tracer side by side.
enum class Shown { drawn, reference, difference, compare };

struct RenderOptions {
  std::string sky;
  std::string output;
  std::vector<std::string> times;
  std::string view;  ///< empty: "level" if a level is given, else "dome" for one time, "sheet" for several
  std::string size;
  std::string source;  ///< empty: analytic
  std::string
      sky_light;  ///< empty: both for the spheres; for a level its probes, or sh where `sky` is no level's folder
  std::string component;  ///< empty: all
  std::string occlusion;  ///< of ambient light in a level; empty: screen, but contact where probes light it
  std::string exposure = "auto";
  std::optional<double> yaw_deg;    ///< none: towards the sun or the moon; in a level towards its middle
  std::optional<double> pitch_deg;  ///< none: 18; in a level towards its middle
  double fov_deg = 60.0;
  bool reference = false;
  bool difference = false;
  bool compare = false;
  LightsOption lights;
  std::size_t paths = 64;  ///< of the path tracer, a pixel
  bool json = false;
  ProgressOption progress;
  ThreadsOption threads;
  bool no_tint = false;
  bool no_reflections = false;
  bool validate = false;
  std::string level;   ///< level.toml
  std::string probes;  ///< folder of a baked level whose probes are drawn; empty: none
  std::string camera;  ///< position "X,Y,Z"; empty: a place that sees the whole level
};

struct Size {
  uint32_t width, height;
};

View parseView(const RenderOptions& options);
WelkinVulkanSource parseSource(const RenderOptions& options);
render::SkyLight parseSkyLight(const RenderOptions& options);
LevelLight parseLevelLight(const RenderOptions& options);
Component parseComponent(const RenderOptions& options);
/// What is shown. Throws Error(usage) where more than one thing is asked for.
Shown parseShown(const RenderOptions& options);
/// What corrects the level's ambient light of a kind where surfaces are near. If nothing is asked for: the contact
/// factors of probes, and occlusion in screen space for light that knows no surfaces.
Occlusion parseOcclusion(const RenderOptions& options, LevelLight light);
Size parseSize(const std::string& text, Size fallback);
/// Fixed exposure in stops, or nothing for automatic.
std::optional<double> parseExposure(const std::string& text);
/// The camera's position, metres; nothing if none is given.
std::optional<f64::Number3> parseCamera(const RenderOptions& options);

/// Throws Error(usage) if a value is out of its domain or options do not go together.
void checkOptions(const RenderOptions& options);

}  // namespace welkin::command
