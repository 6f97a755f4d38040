// SPDX-License-Identifier: Apache-2.0
#include "command/level_picture.h"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "command/arguments.h"
#include "command/render_picture.h"
#include "probes/build/subject.h"
#include "render/difference.h"
#include "render/level_query.h"
#include "render/level_reference.h"

namespace welkin::command {
namespace {

using render::FloatImage;

constexpr uint32_t kSamples = 2;  // along each side of a pixel

render::PlacedCamera cameraOf(const level::Scene& scene, const RenderOptions& options) {
  render::PlacedCamera from = render::overview(scene, options.fov_deg * f64::kDegree);
  if (const auto position = parseCamera(options)) {
    from.position = *position;
    render::lookAtMiddle(scene, from.position, from.camera);
  }
  if (options.yaw_deg) from.camera.yaw_rad = *options.yaw_deg * f64::kDegree;
  if (options.pitch_deg) from.camera.pitch_rad = *options.pitch_deg * f64::kDegree;
  return from;
}

render::LevelOptions levelOptions(const RenderOptions& options, LevelLight light) {
  const Component part = parseComponent(options);
  const auto factor = [&](Component own) {
    return part == Component::all || part == Component::ambient || part == own ? 1.0F : 0.0F;
  };
  return {.flat_light = light == LevelLight::flat,
          .tint = !options.no_tint,
          .occlusion = parseOcclusion(options, light) == Occlusion::screen,
          .contact = parseOcclusion(options, light) == Occlusion::contact,
          .glossy = !options.no_reflections,
          .cubemaps = parseSource(options) == WELKIN_VULKAN_CUBEMAP,
          .direct = part == Component::all,
          .parts = {factor(Component::sky), factor(Component::sun_bounce), factor(Component::local)}};
}

/// One camera's pictures.
class Pictures {
 public:
  Pictures(const level::Scene& scene, const RenderOptions& options, Size size)
      : from_(cameraOf(scene, options)), width_(kSamples * size.width), height_(kSamples * size.height) {}

  const render::PlacedCamera& from() const { return from_; }
  FloatImage draw(render::LevelView& view, const FloatImage* traced = nullptr) const {
    return view.draw(width_, height_, from_.camera, from_.position, traced);
  }
  FloatImage occlusion(render::LevelView& view) const {
    return view.drawOcclusion(width_, height_, from_.camera, from_.position);
  }
  FloatImage irradiance(render::LevelView& view) const {
    return view.drawIrradiance(width_, height_, from_.camera, from_.position);
  }
  FloatImage places(render::LevelView& view) const {
    return view.drawPlaces(width_, height_, from_.camera, from_.position);
  }

 private:
  render::PlacedCamera from_;
  uint32_t width_, height_;
};

Size sizeOf(const RenderOptions& options, bool sheet) {
  return parseSize(options.size, sheet ? Size{480, 270} : Size{960, 540});
}

const char* nameOf(LevelLight light) {
  return light == LevelLight::flat ? "flat" : light == LevelLight::sh ? "sh" : "probes";
}

nlohmann::ordered_json jsonOf(const render::IrradianceError& error) {
  return {{"mean", error.mean}, {"rms", error.rms}, {"worst", error.worst}, {"pixels", error.pixels}};
}

render::IrradianceError errorOfNothing(FloatImage drawn, const render::TracedImage& traced) {
  for (std::size_t i = 0; i < drawn.rgba.size(); ++i)
    if (i % 4 < 3) drawn.rgba[i] = 0.0F;
  return render::errorOf(drawn, traced, kSamples);
}

/// Adds the error of the CPU's look-ups, and that of the frame against them, both over the tracer's mean.
void addQuery(FloatImage query, const FloatImage& drawn, const render::TracedImage& traced,
              nlohmann::ordered_json& numbers) {
  for (std::size_t i = 0; i < query.rgba.size(); i += 4)
    if (traced.irradiance.rgba[i + 3] == 0.0F) query.rgba[i + 3] = 0.0F;
  numbers["error"]["query"] = jsonOf(render::errorOf(query, traced, kSamples));
  const render::TracedImage exact{std::move(query), std::vector<float>(traced.error.size(), 0.0F), 0};
  render::IrradianceError between = render::errorOf(drawn, exact, kSamples);
  const double unit = numbers["mean_irradiance"];
  for (double* value : {&between.mean, &between.rms, &between.worst}) *value *= unit > 0.0 ? between.unit / unit : 0.0;
  numbers["frame_to_query"] = jsonOf(between);
}

}  // namespace

render::Picture drawLevel(render::VulkanDevice& device, const Sky& sky, const level::Scene& scene, WelkinLevel* baked,
                          const render::LevelProbes* probes, const RenderOptions& options) {
  const bool sheet = options.times.size() > 1;
  const Pictures pictures(scene, options, sizeOf(options, sheet));
  const Exposure exposure(sky, options.exposure);
  const bool occlusion = parseComponent(options) == Component::occlusion;
  render::LevelView view(device, sky, scene, levelOptions(options, parseLevelLight(options)), baked);
  return drawTimes(options, sheet, [&](double time_h) -> std::vector<render::Picture> {
    view.setTime(time_h);
    if (occlusion) return {render::encode(pictures.occlusion(view), kSamples)};
    if (probes != nullptr) view.setProbes(probes->at(time_h));
    const FloatImage image = pictures.draw(view);
    return {render::tonemap(image, exposure.of({&image, 1}), kSamples)};
  });
}

render::Picture drawTraced(render::VulkanDevice& device, const Sky& sky, const level::Scene& scene, WelkinLevel* baked,
                           const RenderOptions& options, nlohmann::ordered_json& numbers) {
  const Shown shown = parseShown(options);
  const bool sheet = options.times.size() > 1;
  const LevelLight light = parseLevelLight(options);
  const Pictures pictures(scene, options, sizeOf(options, sheet || shown == Shown::compare));
  const Exposure exposure(sky, options.exposure);
  const auto limit = options.threads.limit();
  const build::Subject subject = build::readLevel(options.level);
  const geometry::Tracer tracer(subject.level->surfaces, pictures.from().position);
  const render::LevelOptions drawn_with = levelOptions(options, light);
  const transfer::RelightScale& scale = subject.level->section.scale;
  render::TraceSettings settings{options.paths, kSamples, drawn_with.parts, drawn_with.direct};
  settings.parts.sky *= static_cast<float>(scale.sky);
  settings.parts.sun_bounce *= static_cast<float>(scale.sun_bounce);
  settings.lowest_m = render::seaBelow(scene, pictures.from().position).value_or(settings.lowest_m);
  render::LevelView view(device, sky, scene, drawn_with, baked);
  const std::vector<reference::LocalLight> lights = options.lights.lights();
  ProgressReport progress(options.progress.style());
  numbers["pictures"] = nlohmann::ordered_json::array();

  return drawTimes(options, sheet, [&](double time_h) -> std::vector<render::Picture> {
    view.setTime(time_h);
    const reference::DistantLight distant(subject.sky.sky, time_h);
    const FloatImage places = pictures.places(view);
    const render::TracedImage traced =
        render::traceSurfaces(reference::pathScene(tracer, distant, lights, subject.level->section.transfer.bounces),
                              places, pictures.from().camera, pictures.from().position, settings, progress.progress());
    const FloatImage irradiance = pictures.irradiance(view);
    const render::IrradianceError error = render::errorOf(irradiance, traced, kSamples);
    nlohmann::ordered_json numbers_here = {
        {"time_h", time_h},
        {"paths", traced.paths},
        {"mean_irradiance", error.unit},
        {"noise", error.noise},
        {"error", {{nameOf(light), jsonOf(error)}, {"nothing", jsonOf(errorOfNothing(irradiance, traced))}}}};
    const bool has_contact = drawn_with.contact && !scene.contact.empty();  // the look-ups know none
    if (baked != nullptr && !drawn_with.direct && !has_contact)
      addQuery(render::queryPlaces(*baked, places, pictures.from().camera, pictures.from().position), irradiance,
               traced, numbers_here);
    render::Picture picture;
    if (shown == Shown::difference) {
      picture = render::differencePicture(irradiance, traced, kSamples, error);
    } else {
      const FloatImage own = pictures.draw(view);
      const FloatImage by_paths = pictures.draw(view, &traced.irradiance);
      const double factor = exposure.of({&own, 1});
      const auto tone = [&](const FloatImage& image) { return render::tonemap(image, factor, kSamples); };
      picture = tone(by_paths);
      if (shown == Shown::compare) {
        render::LevelView flat(device, sky, scene, levelOptions(options, LevelLight::flat));
        flat.setTime(time_h);
        const render::IrradianceError flat_error = render::errorOf(pictures.irradiance(flat), traced, kSamples);
        numbers_here["error"]["flat"] = jsonOf(flat_error);
        const std::string tracer_text =
            fmt::format("path tracer, {} paths a pixel: noise {:.1f} %", traced.paths, 100.0 * error.noise);
        picture = render::contactSheet({{"flat ambient light: " + errorText(flat_error), {tone(pictures.draw(flat))}},
                                        {"probes: " + errorText(error), {tone(own)}},
                                        {tracer_text, {std::move(picture)}}});
      }
    }
    numbers["pictures"].push_back(std::move(numbers_here));
    std::vector<render::Picture> result;
    result.push_back(std::move(picture));
    return result;
  });
}

}  // namespace welkin::command
