// SPDX-License-Identifier: Apache-2.0
// Draws the level for a state by the passes of tools/render.
#pragma once

#include <map>
#include <memory>
#include <optional>

#include "render/difference.h"
#include "render/level_view.h"
#include "view/day.h"
#include "view/level.h"

namespace welkin::view {

render::Camera cameraOf(const Eye& eye);

/// The sample of a sky with the state's changes.
WelkinSkySample sampleOf(const Sky& sky, double time_h, const Changes& changes);

class Painter {
 public:
  /// All must outlive the object.
  Painter(render::VulkanDevice& device, Level& level);

  /// Before the level's bake is replaced: lets go of all that is of it.
  void forgetLevel();

  /// Opens another bake of the level. Throws Error; then an earlier one stays.
  void openOther(const std::filesystem::path& folder);
  bool hasOther() const { return other_ != nullptr; }

  /// A picture of this size. Fills `error` where two lights are compared. With `quick` shadows are coarser, and the sea
  /// mirrors the sky alone.
  render::Picture paint(const State& state, uint32_t width, uint32_t height, bool quick,
                        std::optional<render::IrradianceError>& error);

  /// The device's time of each pass of the last picture of the baked level; none before one is drawn.
  std::vector<render::PassTime> passTimes() const {
    return baked_ ? baked_->passTimes() : std::vector<render::PassTime>{};
  }

 private:
  struct Size {
    uint32_t width, height;
    friend bool operator==(const Size&, const Size&) = default;
  };
  /// What the tracer's picture depends on.
  struct TracedFor {
    double time_h;
    Eye eye;
    Changes changes;
    std::size_t paths;
    Size size;
    friend bool operator==(const TracedFor&, const TracedFor&) = default;
  };

  render::LevelView& viewOf(Light light);
  render::LevelOptions optionsOf(const State& state, Light light) const;
  void prepare(render::LevelView& view, const State& state, Light light);
  render::FloatImage draw(const State& state, Light light, Size size);
  render::FloatImage irradiance(const State& state, Light light, Size size);
  const render::TracedImage& traced(const State& state, Size size);
  double exposure(const State& state, const render::FloatImage& image) const;

  render::VulkanDevice& device_;
  Level& level_;
  double brightest_;                                 // render::brightestLuminance of the level's sky
  std::unique_ptr<render::LevelView> baked_, open_;  ///< made when first drawn
  std::unique_ptr<baked::LevelFolder> other_;        ///< null without another bake
  std::unique_ptr<render::LevelView> other_view_;
  bool is_quick_ = false;
  std::size_t light_changes_ = 0;  ///< of the level's folder, when a picture was last drawn
  std::optional<TracedFor> traced_for_;
  render::TracedImage traced_;
  std::optional<std::pair<double, Changes>> spheres_for_;
  ProbeShade spheres_shade_ = ProbeShade::off;
  const render::LevelView* spheres_view_ = nullptr;
};

}  // namespace welkin::view
