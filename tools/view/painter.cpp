// SPDX-License-Identifier: Apache-2.0
#include "view/painter.h"

#include <algorithm>
#include <cmath>

#include "render/level_reference.h"
#include "render/tone.h"
#include "sky/base/error.h"
#include "view/beside.h"
#include "view/probes.h"
#include "view/quick_tone.h"

namespace welkin::view {
namespace {

constexpr uint32_t kQuickShadow = 2048;
constexpr double kQuickError_pixels = 0.4;  // of a picture that moves, and is 2 to 4 times smaller than the window

void desaturate(float rgb[3], double saturation) {
  const f64::Number3 c = f64::desaturate({double{rgb[0]}, double{rgb[1]}, double{rgb[2]}}, saturation);
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<float>(c[i]);
}

/// Takes rows out between the view and the legend below it, so that the picture has the height of the view.
render::Picture withoutGap(render::Picture picture, uint32_t height) {
  const std::ptrdiff_t row = std::ptrdiff_t{3} * picture.width;
  const uint32_t legend = std::min(picture.height - std::min(height, picture.height), height);
  const auto from = picture.rgb.begin() + row * (height - legend);
  picture.rgb.erase(from, from + row * legend);
  picture.height = height;
  return picture;
}

}  // namespace

render::Camera cameraOf(const Eye& eye) {
  return {eye.yaw_deg * f64::kDegree, eye.pitch_deg * f64::kDegree, eye.fov_deg * f64::kDegree};
}

WelkinSkySample sampleOf(const Sky& sky, double time_h, const Changes& changes) {
  WelkinSkySample sample{};
  if (!sky.sample(time_h, sample)) throw base::Error(base::ExitStatus::internal, "welkin_sky_sample failed");
  if (!changes.tint) std::fill_n(sample.polarising_tint, 3, 1.0F);
  if (changes.saturation < 1.0) {
    for (std::uint32_t i = 0; i < sample.coefficient_count; ++i) desaturate(sample.ambient_sh[i], changes.saturation);
    for (std::uint32_t k = 0; k < sample.mode_count; ++k) desaturate(sample.mode_weight[k], changes.saturation);
    desaturate(sample.ambient_ground, changes.saturation);
    sample.ambient_saturation *= static_cast<float>(changes.saturation);
  }
  return sample;
}

Painter::Painter(render::VulkanDevice& device, Level& level)
    : device_(device), level_(level), brightest_(render::brightestLuminance(level.sky())) {}

void Painter::forgetLevel() {
  baked_.reset();
  open_.reset();
  spheres_for_.reset();
  traced_for_.reset();
  light_changes_ = 0;
}

void Painter::openOther(const std::filesystem::path& folder) {
  auto opened = std::make_unique<baked::LevelFolder>(levelFiles(folder, level_.files().level).folder);
  other_view_.reset();
  other_ = std::move(opened);
}

render::LevelOptions Painter::optionsOf(const State& state, Light light) const {
  const Changes& c = state.changes;
  render::LevelOptions options;
  options.flat_light = light == Light::flat;
  options.tint = c.tint;
  options.occlusion = c.occlusion;
  options.contact = c.contact && light == Light::baked;  // factors are of this bake's probes alone
  options.direct = c.direct;
  options.reflections = !is_quick_;
  if (is_quick_) options.shadow_size = kQuickShadow;
  if (is_quick_) options.coarse = kQuickError_pixels;
  options.parts = {static_cast<float>(c.sky), static_cast<float>(c.sun_bounce), static_cast<float>(c.local)};
  return options;
}

render::LevelView& Painter::viewOf(Light light) {
  const bool baked = light == Light::baked || light == Light::reference;
  if (light == Light::other) {
    if (!other_view_)
      other_view_ = std::make_unique<render::LevelView>(device_, other_->sky(), level_.scene(), optionsOf({}, light),
                                                        other_->level().get());
    return *other_view_;
  }
  std::unique_ptr<render::LevelView>& view = baked ? baked_ : open_;
  if (!view)
    view = std::make_unique<render::LevelView>(device_, level_.sky(), level_.scene(), optionsOf({}, light),
                                               baked ? level_.baked().level().get() : nullptr);
  return *view;
}

void Painter::prepare(render::LevelView& view, const State& state, Light light) {
  const std::size_t changes = level_.baked().lightChanges();
  if (changes != light_changes_ && baked_) baked_->forgetLight();
  light_changes_ = changes;
  view.setOptions(optionsOf(state, light));
  view.setSample(sampleOf(light == Light::other ? other_->sky() : level_.sky(), state.time_h, state.changes));
}

render::FloatImage Painter::irradiance(const State& state, Light light, Size size) {
  if (light == Light::reference) return traced(state, size).irradiance;
  render::LevelView& view = viewOf(light);
  prepare(view, state, light);
  return view.drawIrradiance(size.width, size.height, cameraOf(state.eye), state.eye.position);
}

render::FloatImage Painter::draw(const State& state, Light light, Size size) {
  const render::FloatImage* own = light == Light::reference ? &traced(state, size).irradiance : nullptr;
  render::LevelView& view = viewOf(light);
  prepare(view, state, light);
  const auto spheres_for = std::pair(state.time_h, state.changes);
  if (light == Light::baked || light == Light::reference) {
    if (spheres_for_ != spheres_for || spheres_shade_ != state.probes || spheres_view_ != &view)
      view.setProbes(spheresOf(level_, state.time_h, state.changes, state.probes, render::openGround(view.sample())));
    spheres_for_ = spheres_for;
    spheres_shade_ = state.probes;
    spheres_view_ = &view;
  }
  return view.draw(size.width, size.height, cameraOf(state.eye), state.eye.position, own);
}

const render::TracedImage& Painter::traced(const State& state, Size size) {
  const TracedFor wanted{state.time_h, state.eye, state.changes, state.pixel_paths, size};
  if (traced_for_ == wanted) return traced_;
  render::LevelView& view = viewOf(Light::baked);
  prepare(view, state, Light::baked);
  const render::Camera camera = cameraOf(state.eye);
  const build::BakeSection& section = level_.subject().level->section;
  render::TraceSettings settings{state.pixel_paths, 1, optionsOf(state, Light::baked).parts, state.changes.direct};
  settings.parts.sky *= static_cast<float>(section.scale.sky);
  settings.parts.sun_bounce *= static_cast<float>(section.scale.sun_bounce);
  settings.lowest_m = render::seaBelow(level_.scene(), state.eye.position).value_or(settings.lowest_m);
  const reference::DistantLight distant(level_.subject().sky.sky, state.time_h);
  const render::FloatImage places = view.drawPlaces(size.width, size.height, camera, state.eye.position);
  traced_ = render::traceSurfaces(reference::pathScene(level_.tracer(), distant, {}, section.transfer.bounces), places,
                                  camera, state.eye.position, settings, {});
  traced_for_ = wanted;
  return traced_;
}

double Painter::exposure(const State& state, const render::FloatImage& image) const {
  if (state.exposure_ev) return std::exp2(*state.exposure_ev);
  return render::automaticExposure(render::logAverageLuminance({&image, 1}), brightest_);
}

render::Picture Painter::paint(const State& state, uint32_t width, uint32_t height, bool quick,
                               std::optional<render::IrradianceError>& error) {
  const Size size{width, height};
  is_quick_ = quick;
  error.reset();
  if (!state.compare) {
    const render::FloatImage image = draw(state, state.light, size);
    return quickTone(image, exposure(state, image));
  }
  const Comparison& compare = *state.compare;
  const render::FloatImage drawn = irradiance(state, compare.first, size);
  render::TracedImage against;
  if (compare.second == Light::reference) {
    against = traced(state, size);
  } else {
    against.irradiance = irradiance(state, compare.second, size);
    against.error.assign(std::size_t{width} * height, 0.0F);
  }
  error = render::errorOf(drawn, against, 1);
  if (compare.beside == Beside::difference)
    return withoutGap(render::differencePicture(drawn, against, 1, *error), height);
  const render::FloatImage first = draw(state, compare.first, size);
  const double factor = exposure(state, first);
  const render::Picture a = quickTone(first, factor);
  const render::Picture b = quickTone(draw(state, compare.second, size), factor);
  return compare.beside == Beside::wipe ? wiped(a, b, compare.at) : sideBySide(a, b);
}

}  // namespace welkin::view
