// SPDX-License-Identifier: Apache-2.0
// The constants of a picture of a level: camera, shadow map, light, sea.
#pragma once

#include <welkin/welkin.h>

#include <optional>

#include "probes/level/scene.h"
#include "render/camera.h"
#include "render/level_volume.h"
#include "render/shaders/level_constants.h"

namespace welkin::render {

/// Options for drawing a level.
struct LevelOptions {
  bool flat_light = false;      ///< ambient light of one colour instead of the spherical harmonics
  bool tint = true;             ///< the dome's polarising tint
  bool occlusion = true;        ///< occlusion in screen space darkens ambient light
  bool contact = false;         ///< the scene's contact factors, where it has any, multiply ambient light
  bool waves = true;            ///< false: the sea is a mirror
  bool reflections = true;      ///< false: the sea mirrors the sky alone
  bool glossy = false;          ///< materials reflect the sky and show the sun's or moon's highlight; else all is matt
  bool cubemaps = false;        ///< takes the dome and the sky in the sea from the baked cubemaps, with their tint
  bool direct = true;           ///< false: sun, moon, lamps and emission light nothing; their bounced light stays
  bool probes = false;          ///< the ambient light is that of a baked level's probes
  ProbeParts parts{};           ///< factors on the light of probes
  double mist_per_m = 1.2e-4;   ///< extinction of the air; 0: none
  double coarse = 0.0;          ///< error of simplified meshes, pixels of the picture; 0: meshes as they are
  uint32_t shadow_size = 4096;  ///< edge of the shadow map, texels
};

/// Returns the sun, or the moon when the sun gives no light. Null when neither shines from above the horizon.
const WelkinLight* lightOf(const WelkinSkySample& sample);

/// Constants of a view of `width` x `height` pixels. With `mirrored` the camera is reflected in the sea's surface and
/// nothing below the sea is drawn.
render::shaders::LevelConstants levelConstants(const level::Scene& scene, const WelkinSkySample& sample,
                                               const Camera& camera, const f64::Number3& position, uint32_t width,
                                               uint32_t height, const LevelOptions& options, bool mirrored);

/// The height of the sea that a camera at `position` looks down on; none below it or without a sea. What lies lower is
/// seen through water.
std::optional<double> seaBelow(const level::Scene& scene, const f64::Number3& position);

/// A camera south-east of the level and a little above, which sees all of it.
struct PlacedCamera {
  Camera camera;
  f64::Number3 position;
};
PlacedCamera overview(const level::Scene& scene, double fov_rad);

/// Turns a camera towards the middle of the level.
void lookAtMiddle(const level::Scene& scene, const f64::Number3& position, Camera& camera);

}  // namespace welkin::render
