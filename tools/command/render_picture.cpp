// SPDX-License-Identifier: Apache-2.0
#include "command/render_picture.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "command/arguments.h"
#include "render/views.h"
#include "shared.h"

namespace welkin::command {
namespace {

/// The pictures of one instant, in the order of the sheet's rows.
std::vector<render::FloatImage> drawInstant(render::Views& views, const RenderOptions& options, View view, bool sheet) {
  render::Camera camera = render::towardsLight(views.sample());
  if (options.yaw_deg) camera.yaw_rad = *options.yaw_deg * f64::kDegree;
  camera.pitch_rad = options.pitch_deg.value_or(18.0) * f64::kDegree;
  camera.fov_rad = options.fov_deg * f64::kDegree;
  render::Camera from_the_side =
      camera;  // the light comes from behind and the left, so that the spheres show their round
  if (!options.yaw_deg) from_the_side.yaw_rad += 120.0 * f64::kDegree;
  const Size wide = parseSize(options.size, sheet ? Size{320, 180} : Size{768, 432});
  const Size dome = sheet ? Size{wide.width, wide.width} : parseSize(options.size, {512, 512});
  std::vector<render::FloatImage> images;
  if (view == View::dome || view == View::sheet) images.push_back(views.dome(dome.width, dome.height, true));
  if (view == View::horizon || view == View::sheet)
    images.push_back(views.perspective(wide.width, wide.height, camera, true));
  if (view == View::spheres || view == View::sheet)
    images.push_back(views.spheres(wide.width, wide.height, from_the_side, parseSkyLight(options)));
  return images;
}

}  // namespace

Exposure::Exposure(const Sky& sky, const std::string& option)
    : stops_(parseExposure(option)), day_(render::brightestLuminance(sky)) {}

double Exposure::of(std::span<const render::FloatImage> images) const {
  return stops_ ? std::exp2(*stops_) : render::automaticExposure(render::logAverageLuminance(images), day_);
}

std::string hourLabel(double time_h) {
  return render::clockLabel(time_h - 24.0 * std::floor(time_h / 24.0));
}

render::Picture drawTimes(const RenderOptions& options, bool sheet,
                          const std::function<std::vector<render::Picture>(double time_h)>& draw) {
  std::vector<render::SheetColumn> columns;
  for (const std::string& time : options.times) {
    const double time_h = parseTime(time);
    columns.push_back({hourLabel(time_h), draw(time_h)});
  }
  return sheet ? render::contactSheet(columns) : std::move(columns.front().pictures.front());
}

render::Picture drawSky(render::VulkanDevice& device, const Sky& sky, const RenderOptions& options) {
  const View view = parseView(options);
  const bool sheet = options.times.size() > 1 || view == View::sheet;
  render::Views views(device, sky, parseSource(options));
  const Exposure exposure(sky, options.exposure);
  return drawTimes(options, sheet, [&](double time_h) {
    views.setTime(time_h, !options.no_tint);
    const std::vector<render::FloatImage> images = drawInstant(views, options, view, sheet);
    std::vector<render::Picture> pictures;
    for (const render::FloatImage& image : images) pictures.push_back(render::tonemap(image, exposure.of(images)));
    return pictures;
  });
}

}  // namespace welkin::command
