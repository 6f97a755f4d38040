// SPDX-License-Identifier: Apache-2.0
// A bake of the sectors that are out of date, in the background. It works on a copy of the bake's folder, so that until
// its end, and where it is cancelled or killed, the folder holds the old sectors.
#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "probes/geometry/sector.h"

namespace welkin::view {

enum class RebakeState { running, done, cancelled, failed };
inline constexpr const char* kRebakeStates[] = {"running", "done", "cancelled", "failed"};

/// How far a rebake is.
struct RebakeStatus {
  RebakeState state = RebakeState::running;
  std::string stage;                         ///< the bake's, such as "sectors"
  std::size_t done = 0, total = 0;           ///< pieces of the stage; a total of 0 is unknown
  std::vector<geometry::SectorId> finished;  ///< sectors that were baked anew, in this order
  std::string message;                       ///< of a failure
};

class Rebake {
 public:
  /// Begins. `sectors`: names of the only ones, separated by commas; empty: all that are out of date. Throws Error
  /// where the copy FOLDER.rebake cannot be made.
  Rebake(std::filesystem::path level, std::filesystem::path folder, std::string sectors);
  /// Cancels, and removes the copy.
  ~Rebake();
  Rebake(const Rebake&) = delete;
  Rebake& operator=(const Rebake&) = delete;

  RebakeStatus status() const;
  void cancel() { cancelled_ = true; }
  /// The copy, in which finished sectors are.
  const std::filesystem::path& copy() const { return copy_; }

  /// Takes what a done rebake has made into the folder, the report last. Throws Error(file).
  void take();

 private:
  void run(const std::string& sectors);

  std::filesystem::path level_, folder_, copy_;
  std::atomic<bool> cancelled_ = false;
  mutable std::mutex mutex_;
  RebakeStatus status_;
  std::thread thread_;
};

}  // namespace welkin::view
