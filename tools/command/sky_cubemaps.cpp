// SPDX-License-Identifier: Apache-2.0
#include "command/sky_cubemaps.h"

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "sky/cubemap/exr.h"

namespace welkin::command {
namespace {

det::Number3 groundAt(const model::SkyProjector& projector, const model::SkyInstant& instant) {
  return instant.groundRadiance(projector.project(instant).horizontal_irradiance);
}

}  // namespace

std::vector<cubemap::Cubemap> renderCubemaps(const bake::SkyFile& file, const SkyPlan& plan,
                                             ProgressReport::Style style, std::size_t& saturated) {
  std::vector<cubemap::Cubemap> cubemaps;
  if (plan.cubemap_time_h.empty()) return cubemaps;
  ProgressReport progress(style, "cubemaps", plan.cubemap_time_h.size());
  const model::SkyProjector projector(file.sky.luminance, 1);
  for (const double time_h : plan.cubemap_time_h) {
    const model::SkyInstant instant(file.sky, time_h);
    cubemaps.push_back(cubemap::renderCubemap(instant, groundAt(projector, instant), plan.cubemap_size,
                                              plan.cubemap_format, [] { return !interrupted(); }));
    saturated += cubemaps.back().saturated;
    if (!progress.step()) throw base::Error(base::ExitStatus::interrupted, "interrupted; nothing was written");
  }
  return cubemaps;
}

void writeImages(const bake::SkyFile& file, const SkyPlan& plan, SkyOutputs& outputs, ProgressReport::Style style,
                 std::size_t& saturated) {
  const auto& times = plan.cubemap_time_h;
  if (times.empty()) return;
  base::makeFolder(outputs.folder() / "cubemaps");
  ProgressReport progress(style, "images", times.size());
  const model::SkyProjector projector(file.sky.luminance, 1);
  const table::Progress keep_going = [] { return !interrupted(); };
  for (const double time_h : times) {
    const model::SkyInstant instant(file.sky, time_h);
    const auto ground = groundAt(projector, instant);
    for (const auto& [layout, suffix] :
         {std::pair(cubemap::Layout::exr_cube, ".exr"), {cubemap::Layout::exr_latlong, "_latlong.exr"}}) {
      const auto image = cubemap::renderDome(instant, ground, layout, plan.cubemap_size, keep_going);
      saturated += image.saturated;
      outputs.write("cubemaps/" + cubemapName(time_h) + suffix,
                    cubemap::encodeExr(image, layout, file.sky.luminance_unit, keep_going));
    }
    if (!progress.step()) throw base::Error(base::ExitStatus::interrupted, "interrupted; finished files are kept");
  }
}

cubemap::CubemapError measureCubemaps(const bake::SkyFile& file, const SkyPlan& plan,
                                      const std::vector<cubemap::Cubemap>& cubemaps, bake::Certify how,
                                      ProgressReport::Style style) {
  cubemap::CubemapSet set{plan.cubemap_size, plan.cubemap_format, plan.cubemap_time_h, {}};
  for (const cubemap::Cubemap& cubemap : cubemaps) set.texels.emplace_back(cubemap.texels);
  ProgressReport progress(style, "cubemaps' error", 0);
  return cubemap::measureCubemaps(file.sky, set,
                                  how == bake::Certify::full ? cubemap::Effort::full : cubemap::Effort::fast,
                                  [&] { return progress.step(); });
}

}  // namespace welkin::command
