// SPDX-License-Identifier: Apache-2.0
#include "command/render_picture.h"

#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "command/arguments.h"
#include "render/views.h"
#include "shared.h"

namespace welkin::command {
namespace {

/// Luminance of E(up) / pi, the cosine-weighted mean over the upper hemisphere, at the day's brightest quarter hour.
double brightestLuminance(const Sky& sky) {
  double brightest = 0.0;
  for (int quarter = 0; quarter < 96; ++quarter) {
    WelkinSkySample sample;
    const float up[3] = {0.0F, 1.0F, 0.0F};
    float e[3];
    if (!sky.sample(quarter / 4.0, sample) || welkin_sample_irradiance(&sample, up, e) != WELKIN_OK) continue;
    brightest = std::max(brightest, f64::luminanceOf({double{e[0]}, double{e[1]}, double{e[2]}}) / f64::kPi);
  }
  return brightest;
}

/// The pictures of one instant, in the order of the sheet's rows.
std::vector<render::FloatImage> drawInstant(render::Views& views, const RenderOptions& options, View view, bool sheet) {
  render::Camera camera = render::towardsLight(views.sample());
  if (options.yaw_deg) camera.yaw_rad = *options.yaw_deg * f64::kDegree;
  camera.pitch_rad = options.pitch_deg.value_or(18.0) * f64::kDegree;
  camera.fov_rad = options.fov_deg * f64::kDegree;
  render::Camera from_the_side =
      camera;  // the light comes from behind and the left, so that the spheres show their round
  if (!options.yaw_deg) from_the_side.yaw_rad += 120.0 * f64::kDegree;
  const Size wide = parseSize(options, sheet ? Size{320, 180} : Size{768, 432});
  const Size dome = sheet ? Size{wide.width, wide.width} : parseSize(options, {512, 512});
  std::vector<render::FloatImage> images;
  if (view == View::dome || view == View::sheet) images.push_back(views.dome(dome.width, dome.height, true));
  if (view == View::horizon || view == View::sheet)
    images.push_back(views.perspective(wide.width, wide.height, camera, true));
  if (view == View::spheres || view == View::sheet)
    images.push_back(views.spheres(wide.width, wide.height, from_the_side, parseSkyLight(options)));
  return images;
}

/// Calls `draw` for every requested hour, exposes its pictures, and lays several hours side by side.
render::Picture drawTimes(const Sky& sky, const RenderOptions& options, bool sheet, uint32_t samples,
                          const std::function<std::vector<render::FloatImage>(double time_h)>& draw) {
  const std::optional<double> stops = parseExposure(options.exposure);
  const double day = brightestLuminance(sky);
  std::vector<render::SheetColumn> columns;
  for (const std::string& time : options.times) {
    const double time_h = parseTime(time);
    const std::vector<render::FloatImage> images = draw(time_h);
    const double exposure =
        stops ? std::exp2(*stops) : render::automaticExposure(render::logAverageLuminance(images), day);
    render::SheetColumn column{render::clockLabel(time_h - 24.0 * std::floor(time_h / 24.0)), {}};
    for (const render::FloatImage& image : images) column.pictures.push_back(render::tonemap(image, exposure, samples));
    columns.push_back(std::move(column));
  }
  return sheet ? render::contactSheet(columns) : std::move(columns.front().pictures.front());
}

}  // namespace

render::Picture drawSky(render::VulkanDevice& device, const Sky& sky, const RenderOptions& options) {
  const View view = parseView(options);
  const bool sheet = options.times.size() > 1 || view == View::sheet;
  render::Views views(device, sky, parseSource(options));
  return drawTimes(sky, options, sheet, 1, [&](double time_h) {
    views.setTime(time_h, !options.no_tint);
    return drawInstant(views, options, view, sheet);
  });
}

render::Picture drawLevel(render::VulkanDevice& device, const Sky& sky, const level::Scene& scene, WelkinLevel* baked,
                          const render::LevelProbes* probes, const RenderOptions& options) {
  constexpr uint32_t kSamples = 2;  // along each side of a pixel
  const bool sheet = options.times.size() > 1;
  const Size size = parseSize(options, sheet ? Size{480, 270} : Size{960, 540});
  render::PlacedCamera from = render::overview(scene, options.fov_deg * f64::kDegree);
  if (const auto position = parseCamera(options)) {
    from.position = *position;
    render::lookAtMiddle(scene, from.position, from.camera);
  }
  if (options.yaw_deg) from.camera.yaw_rad = *options.yaw_deg * f64::kDegree;
  if (options.pitch_deg) from.camera.pitch_rad = *options.pitch_deg * f64::kDegree;
  const Component part = parseComponent(options);
  const auto factor = [&](Component own) {
    return part == Component::all || part == Component::ambient || part == own ? 1.0F : 0.0F;
  };
  render::LevelView view(device, sky, scene,
                         {.flat_light = parseLevelLight(options) == LevelLight::flat,
                          .tint = !options.no_tint,
                          .occlusion = parseOcclusion(options),
                          .cubemaps = parseSource(options) == WELKIN_VULKAN_CUBEMAP,
                          .direct = part == Component::all,
                          .parts = {factor(Component::sky), factor(Component::sun_bounce), factor(Component::local)}},
                         baked);
  return drawTimes(sky, options, sheet, kSamples, [&](double time_h) {
    view.setTime(time_h);
    if (probes != nullptr) view.setProbes(probes->at(time_h));
    std::vector<render::FloatImage> images;
    images.push_back(view.draw(kSamples * size.width, kSamples * size.height, from.camera, from.position));
    return images;
  });
}

}  // namespace welkin::command
