// SPDX-License-Identifier: Apache-2.0
#include "command/progress.h"

#include <fmt/format.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string_view>

#include "sky/base/error.h"

namespace welkin::command {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> stop_wanted = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // set from a signal handler

timer_t unheard_timer;
constexpr long kPatience_ns = 500'000'000;

extern "C" void onInterrupt(int signal) {
  stop_wanted = true;
  std::signal(signal, SIG_DFL);
  const itimerspec once{{0, 0}, {0, kPatience_ns}};
  timer_settime(unheard_timer, 0, &once, nullptr);
}

/// Ends the process where a library or a long step has not heard the signal in time. That is as safe as a kill: files
/// have their names only when they are whole, and the next bake removes temporary ones.
extern "C" void onUnheard(int) {
  constexpr std::string_view kMessage = "welkin: interrupted; finished files are kept\n";
  const ssize_t written = ::write(STDERR_FILENO, kMessage.data(), kMessage.size());
  static_cast<void>(written);
  ::_exit(static_cast<int>(base::ExitStatus::interrupted));
}

/// fmt::print throws when stderr is full; progress must not end a bake.
void write(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

double seconds(Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

void catchInterrupts() {
  sigevent event{};
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGALRM;
  std::signal(SIGALRM, onUnheard);
  timer_create(CLOCK_MONOTONIC, &event, &unheard_timer);
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
}

ProgressReport::Style ProgressReport::styleOf(const std::string& name) {
  if (name == "bar") return Style::bar;
  if (name == "plain") return Style::plain;
  if (name == "json") return Style::json;
  if (name == "none") return Style::none;
  return isatty(STDERR_FILENO) != 0 ? Style::bar : Style::plain;
}

base::Progress ProgressReport::progress() {
  return base::Progress([this](const Stage& stage, base::Progress::Event event) {
    const bool is_inner = stage.around() != nullptr && stage.around()->around() != nullptr;
    if (is_inner && stage.around()->name() == "sectors")
      countRays(stage, event);
    else if (!is_inner && stage.around() != nullptr) {
      if (event == base::Progress::Event::began) begin(stage);
      if (event == base::Progress::Event::went_on) show(stage);
      if (event == base::Progress::Event::ended) print(stage, true);
    }
    return !stop_wanted;
  });
}

void ProgressReport::begin(const Stage&) {
  start_ = printed_ = Clock::now();
  rays_ = 0;
  note_.clear();
  members_.clear();
}

void ProgressReport::show(const Stage& stage) {
  const auto now = Clock::now();
  const double pause = style_ == Style::bar ? 0.1 : 2.0;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock.owns_lock() && stage.done() < stage.total() && seconds(now - printed_) > pause) {
    printed_ = now;
    print(stage, false);
  }
}

void ProgressReport::countRays(const Stage& sector, base::Progress::Event event) {
  if (sector.done() > 0) {
    const std::lock_guard lock(mutex_);
    const std::uint64_t rays = rays_ + sector.done();
    if (event == base::Progress::Event::ended) rays_ = rays;
    const double per_s = static_cast<double>(rays) / std::max(seconds(Clock::now() - start_), 1e-9);
    note_ = fmt::format("sector {}, {:.2f} Mrays/s", sector.name(), 1e-6 * per_s);
    members_ = {{"sector", sector.name()}, {"rays_per_s", std::round(per_s)}};
  }
  show(*sector.around());
}

void ProgressReport::print(const Stage& stage, bool last) {
  const std::uint64_t done = stage.done();
  const double elapsed = seconds(Clock::now() - start_);
  const std::uint64_t total = std::max(stage.total(), done);  // total() is 0 if the extent is unknown
  std::optional<double> left;                                 // unknown before the first piece is done
  if (done > 0 || total == 0)
    left = total > done ? elapsed * static_cast<double>(total - done) / static_cast<double>(done) : 0.0;
  const std::string left_text = left ? fmt::format("{:.1f} s left", *left) : "";
  switch (style_) {
    case Style::bar: {
      const std::uint64_t filled = total > 0 ? done * 30 / total : 30;
      write(fmt::format("\r{:10} [{:=<{}}{: <{}}] {}/{}  {}  {} {}", stage.name(), "", filled, "", 30 - filled, done,
                        total, left_text, note_, last ? "\n" : ""));
      break;
    }
    case Style::plain:
      write(fmt::format("{}: {}/{}, {:.1f} s{}{}{}{}\n", stage.name(), done, total, elapsed, last || !left ? "" : ", ",
                        last ? "" : left_text, note_.empty() ? "" : ", ", note_));
      break;
    case Style::json: {
      const auto toMilliseconds = [](double time_s) { return std::round(time_s * 1000.0) / 1000.0; };
      nlohmann::ordered_json line = {{"progress", stage.name()},
                                     {"done", done},
                                     {"total", total},
                                     {"elapsed_s", toMilliseconds(elapsed)},
                                     {"left_s", nullptr}};
      if (left) line["left_s"] = toMilliseconds(*left);
      line.update(members_);
      write(line.dump() + "\n");
      break;
    }
    case Style::none:
      break;
  }
}

}  // namespace welkin::command
