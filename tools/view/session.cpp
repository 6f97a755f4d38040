// SPDX-License-Identifier: Apache-2.0
#include "view/session.h"

#include <chrono>
#include <cmath>
#include <limits>

#include "view/actions.h"
#include "view/beside.h"
#include "view/words.h"

namespace welkin::view {

using f64::Number3;

namespace {

constexpr uint32_t kLeastDivisor = 2, kMostDivisor = 4;
constexpr double kSlow_s = 0.040, kFast_s = 0.015;  // a step of the divisor changes the time by 2.25 at most

}  // namespace

Session::Session(render::VulkanDevice& device, Level& level, uint32_t width, uint32_t height)
    : device_(device),
      level_(level),
      width_(width),
      height_(height),
      edits_(level.files().level),
      text_(std::make_shared<const std::string>(edits_.text())),
      baked_text_(level.files().warning.empty() ? edits_.text() : std::string()),
      day_(dayOf(level.sky())),
      painter_(device_, level_) {
  state_.eye = overview();
}

void Session::perform(const std::vector<std::string>& words) {
  if (!words.empty()) performAction(*this, words);
}

void Session::perform(const std::string& line) {
  perform(wordsOf(line));
}

void Session::set(const State& state) {
  if (state.changes != state_.changes) history_.record(now(), joins_);
  replace(state);
}

void Session::replace(const State& state) {
  const bool light_changed = state.time_h != state_.time_h || state.changes != state_.changes;
  if (light_changed || state.probe != state_.probe) probe_.reset();
  const auto same_point = [](const std::optional<baked::SurfacePoint>& a, const std::optional<baked::SurfacePoint>& b) {
    return a.has_value() == b.has_value() && (!a || (a->position == b->position && a->normal == b->normal));
  };
  if (!same_point(state.point, state_.point)) answer_.reset();
  if (state.time_h != state_.time_h || state.truth_paths != state_.truth_paths) answer_fits_ = false;
  picture_.reset();
  error_.reset();
  state_ = state;
  ++version_;
}

void Session::apply(const Undoable& target) {
  State state = state_;
  state.changes = target.changes;
  replace(state);
  if (!target.level || *target.level == edits_.text()) return;
  edits_.set(*target.level);
  edited();
}

void Session::undo() {
  if (const std::optional<Undoable> before = history_.undo(now())) apply(*before);
}

void Session::redo() {
  if (const std::optional<Undoable> after = history_.redo(now())) apply(*after);
}

void Session::resize(uint32_t width, uint32_t height) {
  if (width == width_ && height == height_) return;
  width_ = width;
  height_ = height;
  picture_.reset();
  error_.reset();
  ++version_;
}

const WelkinSkySample& Session::sample() {
  sample_ = sampleOf(level_.sky(), state_.time_h, state_.changes);
  return sample_;
}

const Answer* Session::answer() {
  if (state_.point && !hurry_ && !(answer_ && answer_fits_)) {
    answer_ = std::make_unique<Answer>(answerAt(level_, *state_.point, state_.time_h, state_.truth_paths));
    answer_fits_ = true;
  }
  return answer_.get();
}

const ProbeNumbers* Session::probe() {
  if (state_.probe && !probe_)
    probe_ = std::make_unique<ProbeNumbers>(numbersOf(level_, *state_.probe, state_.time_h, state_.changes));
  return probe_.get();
}

render::Picture Session::picture(bool quick) {
  if (quick) {
    std::optional<render::IrradianceError> error;
    State state = state_;
    const auto without_tracer = [](Light& light) {
      if (light == Light::reference) light = Light::baked;
    };
    without_tracer(state.light);
    if (state.compare) {
      without_tracer(state.compare->first);
      without_tracer(state.compare->second);
    }
    const auto begin = std::chrono::steady_clock::now();
    const auto part = [&](uint32_t pixels) { return std::max(pixels / quick_divisor_, 1U); };
    render::Picture picture = painter_.paint(state, part(width_), part(height_), true, error);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (seconds > kSlow_s && quick_divisor_ < kMostDivisor) ++quick_divisor_;
    if (seconds < kFast_s && quick_divisor_ > kLeastDivisor) --quick_divisor_;
    return picture;
  }
  if (!picture_) picture_ = painter_.paint(state_, width_, height_, false, error_);
  return *picture_;
}

Eye Session::overview() const {
  const Eye eye;
  const render::PlacedCamera placed = render::overview(level_.scene(), eye.fov_deg * f64::kDegree);
  return {placed.position, placed.camera.yaw_rad / f64::kDegree, placed.camera.pitch_rad / f64::kDegree, eye.fov_deg};
}

Number3 Session::rayAt(double x, double y) const {
  const auto rays = render::inverseViewProjection(cameraOf(state_.eye), static_cast<double>(width_) / height_);
  const auto column = [&](std::size_t c) {
    return Number3(double{rays[4 * c]}, double{rays[4 * c + 1]}, double{rays[4 * c + 2]});
  };
  if (state_.compare && state_.compare->beside == Beside::side) x = sideColumn(x, width_);
  const Number3 ray = column(0) * (2.0 * x / width_ - 1.0) + column(1) * (2.0 * y / height_ - 1.0) + column(3);
  return ray / std::sqrt(dot(ray, ray));
}

bool Session::showsSpheres(double x) const {
  if (state_.probes == ProbeShade::off) return false;
  Light light = state_.light;
  if (state_.compare) {
    const Comparison& c = *state_.compare;
    if (c.beside == Beside::difference) return false;
    const double line = c.beside == Beside::side ? 0.5 : c.at;
    light = x < line * width_ ? c.first : c.second;
  }
  return light == Light::baked || light == Light::reference;
}

void Session::click(double x, double y) {
  constexpr double kFar_m = 1e5;
  const Number3 ray = rayAt(x, y);
  const auto hit = level_.tracer().closest(state_.eye.position, ray, kFar_m);
  State state = state_;
  state.probe.reset();
  state.point.reset();
  if (showsSpheres(x)) state.probe = probeOnRay(level_, state.eye.position, ray, hit ? hit->distance : kFar_m);
  if (!state.probe && hit) state.point = baked::SurfacePoint{hit->position, hit->normal};
  set(state);
}

}  // namespace welkin::view
