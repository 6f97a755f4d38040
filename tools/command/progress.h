// SPDX-License-Identifier: Apache-2.0
// How far a bake is, on stderr, and whether someone asked it to stop.
#pragma once

#include <atomic>
#include <chrono>
#include <mutex>
#include <nlohmann/json.hpp>
#include <string>

namespace welkin::command {

/// Turns the first SIGINT or SIGTERM into a wish to stop; a second one ends the process.
void catchInterrupts();
bool interrupted();

class ProgressReport {
 public:
  enum class Style { bar, plain, json, none };

  /// "bar", "plain", "json", "none", or "auto": a bar on a terminal, plain lines elsewhere.
  static Style styleOf(const std::string& name);

  /// `total`: pieces; 0 when nobody knows.
  ProgressReport(Style style, std::string what, std::size_t total);
  ~ProgressReport();

  /// So many more pieces are done; from any thread. False when the work should stop.
  bool step(std::size_t pieces = 1);
  /// Shown beside the counts: text, and members that the JSON line gets.
  void note(std::string text, nlohmann::ordered_json members);

 private:
  void print(std::size_t done, bool last);

  Style style_;
  std::string what_;
  std::size_t total_;
  std::atomic<std::size_t> done_ = 0;
  std::chrono::steady_clock::time_point start_, printed_;
  std::mutex mutex_;
  std::string note_;
  nlohmann::ordered_json members_ = nlohmann::ordered_json::object();
};

}  // namespace welkin::command
