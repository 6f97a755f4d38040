// SPDX-License-Identifier: Apache-2.0
// Progress of work on stderr, and the user's request to stop it.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

#include "sky/base/progress.h"

namespace welkin::command {

/// Turns the first SIGINT or SIGTERM into a request to stop. A second one ends the process, as do 0.5 s in which no
/// work has heard the first.
void catchInterrupts();

/// Shows the stages of some work, one after the other. While sectors are traced it also shows their rays.
class ProgressReport {
 public:
  enum class Style { bar, plain, json, none };

  /// The style of a name: "bar", "plain", "json", "none", or "auto" (a bar on a terminal, else plain lines).
  static Style styleOf(const std::string& name);

  explicit ProgressReport(Style style) : style_(style) {}

  /// The progress to pass to the work. This object must outlive the work. Stops the work when the user asks for it.
  base::Progress progress();

 private:
  using Stage = base::Progress::Stage;
  void begin(const Stage& stage);
  void show(const Stage& stage);
  void countRays(const Stage& sector, base::Progress::Event event);
  void print(const Stage& stage, bool last);

  Style style_;
  std::chrono::steady_clock::time_point start_, printed_;  ///< start of the stage, time of the last print
  std::mutex mutex_;
  std::uint64_t rays_ = 0;  ///< rays of the stage's finished sectors
  std::string note_;
  nlohmann::ordered_json members_ = nlohmann::ordered_json::object();
};

}  // namespace welkin::command
