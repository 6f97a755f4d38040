// SPDX-License-Identifier: Apache-2.0
#include "welkin/sky_cubemaps.h"

#include "sky/atomic_file.h"
#include "sky/error.h"
#include "sky/exr.h"

namespace welkin::tools {
namespace {

sky::Number3 groundAt(const sky::SkyProjector& projector, const sky::SkyInstant& instant) {
  return instant.groundRadiance(projector.project(instant).horizontal_irradiance);
}

}  // namespace

std::vector<sky::Cubemap> renderCubemaps(const sky::SkyFile& file, const SkyPlan& plan, ProgressReport::Style style,
                                         std::size_t& saturated) {
  std::vector<sky::Cubemap> cubemaps;
  if (plan.cubemap_time_h.empty()) return cubemaps;
  ProgressReport progress(style, "cubemaps", plan.cubemap_time_h.size());
  const sky::SkyProjector projector(file.sky.luminance, 1);
  for (const double time_h : plan.cubemap_time_h) {
    const sky::SkyInstant instant(file.sky, time_h);
    cubemaps.push_back(sky::renderCubemap(instant, groundAt(projector, instant), plan.cubemap_size, plan.cubemap_format,
                                          [] { return !interrupted(); }));
    saturated += cubemaps.back().saturated;
    if (!progress.step()) throw Error(ExitStatus::interrupted, "interrupted; nothing was written");
  }
  return cubemaps;
}

void writeImages(const sky::SkyFile& file, const SkyPlan& plan, SkyOutputs& outputs, ProgressReport::Style style,
                 std::size_t& saturated) {
  const auto& times = plan.cubemap_time_h;
  if (times.empty()) return;
  makeFolder(outputs.folder() / "cubemaps");
  ProgressReport progress(style, "images", times.size());
  const sky::SkyProjector projector(file.sky.luminance, 1);
  const sky::Progress keep_going = [] { return !interrupted(); };
  for (const double time_h : times) {
    const sky::SkyInstant instant(file.sky, time_h);
    const auto ground = groundAt(projector, instant);
    for (const auto& [layout, suffix] :
         {std::pair(sky::Layout::exr_cube, ".exr"), {sky::Layout::exr_latlong, "_latlong.exr"}}) {
      const auto image = sky::renderDome(instant, ground, layout, plan.cubemap_size, keep_going);
      saturated += image.saturated;
      outputs.write("cubemaps/" + cubemapName(time_h) + suffix,
                    sky::encodeExr(image, layout, file.sky.luminance_unit, keep_going));
    }
    if (!progress.step()) throw Error(ExitStatus::interrupted, "interrupted; finished files are kept");
  }
}

sky::CubemapError measureCubemaps(const sky::SkyFile& file, const SkyPlan& plan,
                                  const std::vector<sky::Cubemap>& cubemaps, Certify how, ProgressReport::Style style) {
  sky::CubemapSet set{plan.cubemap_size, plan.cubemap_format, plan.cubemap_time_h, {}};
  for (const sky::Cubemap& cubemap : cubemaps) set.texels.emplace_back(cubemap.texels);
  ProgressReport progress(style, "cubemaps' error", 0);
  return sky::measureCubemaps(file.sky, set, how == Certify::full ? sky::Effort::full : sky::Effort::fast,
                              [&] { return progress.step(); });
}

}  // namespace welkin::tools
