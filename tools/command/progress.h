// SPDX-License-Identifier: Apache-2.0
// How far work is, on stderr, and whether someone asked it to stop.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

#include "sky/base/progress.h"

namespace welkin::command {

/// Turns the first SIGINT or SIGTERM into a wish to stop; a second one ends the process.
void catchInterrupts();

/// Shows the stages of some work, one after the other. Of the stages within one it shows the rays of sectors.
class ProgressReport {
 public:
  enum class Style { bar, plain, json, none };

  /// "bar", "plain", "json", "none", or "auto": a bar on a terminal, plain lines elsewhere.
  static Style styleOf(const std::string& name);

  explicit ProgressReport(Style style) : style_(style) {}

  /// The progress to give to the work, which this object must outlive. Stops the work when the user asks for it.
  base::Progress progress();

 private:
  using Stage = base::Progress::Stage;
  void begin(const Stage& stage);
  void show(const Stage& stage);
  void countRays(const Stage& sector, base::Progress::Event event);
  void print(const Stage& stage, bool last);

  Style style_;
  std::chrono::steady_clock::time_point start_, printed_;  ///< of the stage
  std::mutex mutex_;
  std::uint64_t rays_ = 0;  ///< of the stage's finished sectors
  std::string note_;
  nlohmann::ordered_json members_ = nlohmann::ordered_json::object();
};

}  // namespace welkin::command
