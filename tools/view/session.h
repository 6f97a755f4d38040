// SPDX-License-Identifier: Apache-2.0
// A session of the viewer: the level, the state, and the results that belong to it. Scripts and panels change it by
// the same commands (actions.h).
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "render/difference.h"
#include "view/answer.h"
#include "view/day.h"
#include "view/history.h"
#include "view/level_edits.h"
#include "view/painter.h"
#include "view/probes.h"
#include "view/rates.h"
#include "view/rebake.h"

namespace welkin::view {

/// What a command asks of the program around the session.
class Host {
 public:
  virtual ~Host() = default;
  /// Writes the picture with its panels as a PNG; with `moving` as it is while the camera moves.
  virtual void screenshot(const std::string& path, bool moving = false) = 0;
  /// Draws a picture with its panels, in the window if there is one.
  virtual void show(const render::Picture& picture) = 0;
};

class Session {
 public:
  /// `device` and `level` must outlive the object. Pictures have this size, pixels.
  Session(render::VulkanDevice& device, Level& level, uint32_t width, uint32_t height);

  /// Performs one command. Throws Error(content) for words that are not allowed; then nothing has changed.
  void perform(const std::vector<std::string>& words);
  /// The same for a line of words; an empty line does nothing.
  void perform(const std::string& line);

  const State& state() const { return state_; }
  /// Changes the state. Undo leads back to the light that was before, if that changes.
  void set(const State& state);
  /// While true, changes of the light belong to the last step of undo.
  void joinChanges(bool joined) { joins_ = joined; }
  /// Replaces the text of level.toml, a step of undo. Throws as LevelEdits::set.
  void edit(const std::string& text);
  const LevelEdits& edits() const { return edits_; }
  void save();
  void recover();
  void discard();
  /// Whether level.toml, as it is edited, is not what the shown bake was made of.
  bool editsUnbaked() const { return edits_.text() != baked_text_; }

  /// Saves level.toml and bakes in the background: these sectors, separated by commas, or all that are out of date.
  /// Throws Error(content) while a rebake is at work.
  void rebake(const std::string& sectors);
  void cancelRebake();
  /// Whether a rebake is at work, or its end waits for advance().
  bool rebakes() const { return rebake_ != nullptr; }
  /// Of the rebake, or else of the last one: its `finished` are shown. Null before the first.
  const RebakeStatus* rebakeStatus() const { return status_ ? &*status_ : nullptr; }
  /// Shows the sectors that a rebake has finished since, and takes its end. Call it often while rebakes().
  void advance();

  /// Opens another bake of the level, whose light is Light::other. Throws Error; then an earlier one stays.
  void openOther(const std::string& folder);
  bool hasOther() const { return painter_.hasOther(); }

  /// Take back and make again a change of the light or an edit of level.toml.
  void undo();
  void redo();
  /// Changes whenever the state does.
  std::size_t version() const { return version_; }
  std::size_t undoCount() const { return history_.undoCount(); }
  std::size_t redoCount() const { return history_.redoCount(); }

  Level& level() { return level_; }
  const Level& level() const { return level_; }
  const Day& day() const { return day_; }
  const WelkinSkySample& sample();
  uint32_t width() const { return width_; }
  uint32_t height() const { return height_; }
  void resize(uint32_t width, uint32_t height);

  /// While true, answers that the path tracer gives are not computed: answer() is the last one of the point, or null.
  void setHurry(bool hurry) { hurry_ = hurry; }
  /// The answer for the state's point, the numbers of its probe; null without one. Computed once a change.
  const Answer* answer();
  const ProbeNumbers* probe();
  /// The error of the first of the two compared lights against the second, from picture(); null until that is drawn at
  /// full size, and without a comparison.
  const render::IrradianceError* error() const { return error_ ? &*error_ : nullptr; }

  /// The level's picture without panels. With `quick` at the size over quickDivisor(), and without the path tracer.
  render::Picture picture(bool quick = false);
  /// 2 to 4: rises and falls so that a quick picture takes about a thirtieth of a second.
  uint32_t quickDivisor() const { return quick_divisor_; }

  /// The device's time of each pass of the last picture of the baked level.
  std::vector<render::PassTime> passTimes() const { return painter_.passTimes(); }

  /// How many pictures a second were drawn, when that was measured last; null until it is.
  const Rates* rates() const { return rates_ ? &*rates_ : nullptr; }
  void setRates(const Rates& rates) { rates_ = rates; }

  /// A camera that sees the whole level.
  Eye overview() const;
  /// The direction through a pixel, in pictures side by side too.
  f64::Number3 rayAt(double x, double y) const;
  /// Picks the probe whose sphere is at the pixel, or the surface there; nothing where the sky is.
  void click(double x, double y);

  void setHost(Host* host) { host_ = host; }
  Host& host() const { return *host_; }

 private:
  void replace(const State& state);
  Undoable now() const { return {state_.changes, text_}; }
  void apply(const Undoable& target);
  /// The text of level.toml has changed.
  void edited();
  /// Reads the bake anew; with the rebake's finished sectors, or as the folder has it.
  void reload(bool finished);
  /// Whether the spheres of probes are drawn in this column of the picture.
  bool showsSpheres(double x) const;

  render::VulkanDevice& device_;
  Level& level_;
  uint32_t width_, height_;
  State state_;
  std::size_t version_ = 0;
  History history_;
  LevelEdits edits_;
  std::shared_ptr<const std::string> text_;  ///< of edits_
  std::string baked_text_;                   ///< of level.toml when it was baked
  std::unique_ptr<Rebake> rebake_;
  std::optional<RebakeStatus> status_;
  bool joins_ = false;
  Day day_;
  WelkinSkySample sample_{};
  Painter painter_;
  Host* host_ = nullptr;
  std::optional<render::Picture> picture_;  ///< of the state, whole
  std::optional<render::IrradianceError> error_;
  std::unique_ptr<Answer> answer_;
  bool answer_fits_ = false;  ///< is of the state's time and paths
  bool hurry_ = false;
  uint32_t quick_divisor_ = 3;
  std::optional<Rates> rates_;
  std::unique_ptr<ProbeNumbers> probe_;
};

}  // namespace welkin::view
