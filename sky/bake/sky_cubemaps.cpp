// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/sky_cubemaps.h"

#include "sky/base/atomic_file.h"
#include "sky/cubemap/exr.h"

namespace welkin::bake {
namespace {

det::Number3 groundAt(const model::SkyProjector& projector, const model::SkyInstant& instant) {
  return instant.groundRadiance(projector.project(instant).horizontal_irradiance);
}

}  // namespace

std::vector<cubemap::Cubemap> renderCubemaps(const SkyFile& file, const SkyPlan& plan, const base::Progress& progress,
                                             std::size_t& saturated) {
  std::vector<cubemap::Cubemap> cubemaps;
  if (plan.cubemap_time_h.empty()) return cubemaps;
  const base::Progress cubes = progress.stage("cubemaps", plan.cubemap_time_h.size());
  const model::SkyProjector projector(file.sky.luminance, 1);
  for (const double time_h : plan.cubemap_time_h) {
    const model::SkyInstant instant(file.sky, time_h);
    cubemaps.push_back(
        cubemap::renderCubemap(instant, groundAt(projector, instant), plan.cubemap_size, plan.cubemap_format, cubes));
    saturated += cubemaps.back().saturated;
    cubes.step();
  }
  return cubemaps;
}

void writeImages(const SkyFile& file, const SkyPlan& plan, SkyOutputs& outputs, const base::Progress& progress,
                 std::size_t& saturated) {
  const auto& times = plan.cubemap_time_h;
  if (times.empty()) return;
  base::makeFolder(outputs.folder() / "cubemaps");
  const base::Progress images = progress.stage("images", times.size());
  const model::SkyProjector projector(file.sky.luminance, 1);
  for (const double time_h : times) {
    const model::SkyInstant instant(file.sky, time_h);
    const auto ground = groundAt(projector, instant);
    for (const auto& [layout, suffix] :
         {std::pair(cubemap::Layout::exr_cube, ".exr"), {cubemap::Layout::exr_latlong, "_latlong.exr"}}) {
      const auto image = cubemap::renderDome(instant, ground, layout, plan.cubemap_size, images);
      saturated += image.saturated;
      outputs.write("cubemaps/" + cubemapName(time_h, file.name) + suffix,
                    cubemap::encodeExr(image, layout, file.sky.luminance_unit, images));
    }
    images.step();
  }
}

cubemap::CubemapError measureCubemaps(const SkyFile& file, const SkyPlan& plan,
                                      const std::vector<cubemap::Cubemap>& cubemaps, Certify how,
                                      const base::Progress& progress) {
  cubemap::CubemapSet set{plan.cubemap_size, plan.cubemap_format, plan.cubemap_time_h, {}};
  for (const cubemap::Cubemap& cubemap : cubemaps) set.texels.emplace_back(cubemap.texels);
  return cubemap::measureCubemaps(file.sky, set, how == Certify::full ? cubemap::Effort::full : cubemap::Effort::fast,
                                  progress.stage("cubemaps' error", 0));
}

}  // namespace welkin::bake
