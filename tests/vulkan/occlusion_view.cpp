// SPDX-License-Identifier: Apache-2.0
#include "occlusion_view.h"

#include <cstring>

#include "probes/geometry/directions.h"

namespace welkin::tests {
namespace {

using geometry::Number3;

constexpr double kFar_m = 1e9;
constexpr std::size_t kHeader = 16;  // floats before the pixels
constexpr std::size_t kPixel = 8;    // floats a pixel

void put(float* to, const Number3& v) {
  for (int i = 0; i < 3; ++i) to[i] = static_cast<float>(v[i]);
}

}  // namespace

void OcclusionView::setFound(const std::vector<float>& visibility) {
  for (std::size_t i = 0; i < pixels(); ++i) buffer[kHeader + kPixel * i + 3] = visibility[i];
}

OcclusionView occlusionView(const geometry::Tracer& tracer, const render::Camera& camera, const Number3& eye,
                            uint32_t width, uint32_t height) {
  OcclusionView view{width, height, {}, {}};
  view.buffer.resize(kHeader + kPixel * view.pixels());
  const auto m = render::inverseViewProjection(camera, static_cast<double>(width) / height);
  const auto column = [&](std::size_t i) {
    return Number3(double{m[4 * i]}, double{m[4 * i + 1]}, double{m[4 * i + 2]});
  };
  const Number3 right = column(0) / dot(column(0), column(0));
  const Number3 down = column(1) / dot(column(1), column(1));
  const Number3 forward = column(3);
  put(&view.buffer[0], (right + forward) * (0.5 * width));
  put(&view.buffer[4], (down + forward) * (0.5 * height));
  put(&view.buffer[8], forward);
  const std::int32_t size[2] = {static_cast<std::int32_t>(width), static_cast<std::int32_t>(height)};
  std::memcpy(&view.buffer[12], size, sizeof(size));
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) {
      const Number3 ray =
          forward + column(0) * (2.0 * (x + 0.5) / width - 1.0) + column(1) * (2.0 * (y + 0.5) / height - 1.0);
      const auto hit = tracer.closest(eye, geometry::unit(ray), kFar_m);
      const std::size_t pixel = std::size_t{y} * width + x;
      float* const to = &view.buffer[kHeader + kPixel * pixel];
      put(to, hit ? hit->position - eye : ray * 1e7);
      put(to + 4, hit ? hit->normal : Number3(0.0, 1.0, 0.0));
      if (hit) view.seen.emplace_back(pixel, *hit);
    }
  return view;
}

}  // namespace welkin::tests
