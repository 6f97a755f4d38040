// SPDX-License-Identifier: Apache-2.0
#include "sky/cubemap/cubemap_look.h"

#include <algorithm>
#include <cmath>

namespace welkin::cubemap {

bool isClearOfHorizon(int size, const Number3& direction) {
  return direction.y * size >= 2.0 * std::max(std::abs(direction.x), std::abs(direction.z));
}

CubemapLooks::CubemapLooks(const model::Sky& sky, const CubemapSet& cubemaps, const DirectionCounts& counts)
    : sky_(sky), cubemaps_(cubemaps), directions_(counts) {
  if (sky.luminance.d >= -model::IndicatrixTable::kSteepest) table_.emplace(sky.luminance.d);
  for (const Number3& direction : directions_.staying()) {
    Staying& at = staying_.emplace_back();
    at.ray = model::DomeRay(sky.luminance, direction);
    at.compared = isClearOfHorizon(cubemaps.size, direction);
    if (!at.compared) continue;
    at.footprint = footprintOf(cubemaps.size, direction);
    for (std::size_t k = 0; k < at.texel.size(); ++k)
      at.texel[k] = model::DomeRay(sky.luminance, directionOfTexel(cubemaps.size, at.footprint[k].texel));
  }
}

CubemapLook::CubemapLook(const CubemapLooks& looks, std::size_t index)
    : looks_(&looks), index_(index), instant_(looks.sky(), looks.cubemaps().time_h[index]) {
  staying_.resize(looks.staying().size());
  for (std::size_t i = 0; i < staying_.size(); ++i) {
    const CubemapLooks::Staying& at = looks.staying()[i];
    if (!at.compared) continue;
    Shown& sum = staying_[i];
    sum.model = instant_.dome(at.ray, looks.table());
    for (std::size_t k = 0; k < at.texel.size(); ++k) {
      if (!(at.footprint[k].weight > 0.0)) continue;
      const RenderedTexel texel = render(at.footprint[k].texel, at.texel[k]);
      sum.exact += texel.exact * at.footprint[k].weight;
      sum.shown += texel.rounded * at.footprint[k].weight;
    }
    if (hasFile()) sum.shown = fromFile(at.footprint);
  }
}

CubemapLook::Shown CubemapLook::at(const model::DomeRay& ray, const Footprint& footprint, RecentTexels& recent,
                                   bool own_time) const {
  Shown sum;
  if (!own_time) sum.model = instant_.dome(ray, looks_->table());
  if (own_time || !hasFile())
    for (const TexelShare& share : footprint) {
      if (!(share.weight > 0.0)) continue;
      RenderedTexel& texel = recent[share.texel % recent.size()];
      if (texel.index != share.texel)
        texel = render(share.texel,
                       model::DomeRay(looks_->sky().luminance, directionOfTexel(looks_->cubemaps().size, share.texel)));
      sum.exact += texel.exact * share.weight;
      sum.shown += texel.rounded * share.weight;
    }
  if (hasFile()) sum.shown = fromFile(footprint);
  return sum;
}

RenderedTexel CubemapLook::render(std::size_t index, const model::DomeRay& ray) const {
  RenderedTexel texel{index, Number3(0.0), Number3(0.0)};
  if (ray.direction.y >= 0.0) texel.exact = instant_.dome(ray, looks_->table());
  const format::CubemapFormat format = looks_->cubemaps().format;
  float rgb[3] = {static_cast<float>(texel.exact.x), static_cast<float>(texel.exact.y),
                  static_cast<float>(texel.exact.z)};
  unsigned char bytes[format::kMostTexelBytes];
  format::encodeTexel(format, rgb, bytes);
  format::decodeTexel(format, bytes, rgb);
  texel.rounded = {double{rgb[0]}, double{rgb[1]}, double{rgb[2]}};
  return texel;
}

Number3 CubemapLook::fromFile(const Footprint& footprint) const {
  return filterTexels(looks_->cubemaps().texels[index_].data(), looks_->cubemaps().format, footprint);
}

}  // namespace welkin::cubemap
