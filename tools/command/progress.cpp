// SPDX-License-Identifier: Apache-2.0
#include "command/progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <optional>

namespace welkin::command {
namespace {

using Clock = std::chrono::steady_clock;

std::atomic<bool> stop_wanted = false;
static_assert(std::atomic<bool>::is_always_lock_free);  // set from a signal handler

extern "C" void onInterrupt(int signal) {
  stop_wanted = true;
  std::signal(signal, SIG_DFL);
}

/// fmt::print throws when stderr is full; progress must not end a bake.
void show(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

double seconds(Clock::duration d) {
  return std::chrono::duration<double>(d).count();
}

}  // namespace

void catchInterrupts() {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
}

bool interrupted() {
  return stop_wanted;
}

ProgressReport::Style ProgressReport::styleOf(const std::string& name) {
  if (name == "bar") return Style::bar;
  if (name == "plain") return Style::plain;
  if (name == "json") return Style::json;
  if (name == "none") return Style::none;
  return isatty(STDERR_FILENO) != 0 ? Style::bar : Style::plain;
}

ProgressReport::ProgressReport(Style style, std::string what, std::size_t total)
    : style_(style), what_(std::move(what)), total_(total), start_(Clock::now()), printed_(start_) {}

ProgressReport::~ProgressReport() {
  print(done_, true);
}

bool ProgressReport::step(std::size_t pieces) {
  const std::size_t done = done_ += pieces;
  const auto now = Clock::now();
  const double pause = style_ == Style::bar ? 0.1 : 2.0;
  const std::unique_lock lock(mutex_, std::try_to_lock);
  if (lock.owns_lock() && done < total_ && seconds(now - printed_) > pause) {
    printed_ = now;
    print(done, false);
  }
  return !stop_wanted;
}

void ProgressReport::note(std::string text, nlohmann::ordered_json members) {
  const std::lock_guard lock(mutex_);
  note_ = std::move(text);
  members_ = std::move(members);
}

void ProgressReport::print(std::size_t done, bool last) {
  const double elapsed = seconds(Clock::now() - start_);
  const std::size_t total = std::max(total_, done);  // work whose extent shows as it goes has 0
  std::optional<double> left;                        // nobody knows before a piece is done
  if (done > 0 || total == 0)
    left = total > done ? elapsed * static_cast<double>(total - done) / static_cast<double>(done) : 0.0;
  const std::string left_text = left ? fmt::format("{:.1f} s left", *left) : "";
  switch (style_) {
    case Style::bar: {
      const std::size_t filled = total > 0 ? done * 30 / total : 30;
      show(fmt::format("\r{:10} [{:=<{}}{: <{}}] {}/{}  {}  {} {}", what_, "", filled, "", 30 - filled, done, total,
                       left_text, note_, last ? "\n" : ""));
      break;
    }
    case Style::plain:
      show(fmt::format("{}: {}/{}, {:.1f} s{}{}{}{}\n", what_, done, total, elapsed, last || !left ? "" : ", ",
                       last ? "" : left_text, note_.empty() ? "" : ", ", note_));
      break;
    case Style::json: {
      const auto toMilliseconds = [](double time_s) { return std::round(time_s * 1000.0) / 1000.0; };
      nlohmann::ordered_json line = {{"progress", what_},
                                     {"done", done},
                                     {"total", total},
                                     {"elapsed_s", toMilliseconds(elapsed)},
                                     {"left_s", nullptr}};
      if (left) line["left_s"] = toMilliseconds(*left);
      line.update(members_);
      show(line.dump() + "\n");
      break;
    }
    case Style::none:
      break;
  }
}

}  // namespace welkin::command
