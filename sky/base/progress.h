// SPDX-License-Identifier: Apache-2.0
// How long work tells how far it is, and how it is told to stop: the one protocol of every loop that may take a while.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

namespace welkin::base {

/// A counter of finished pieces, and the listener behind it. Copies count into the same stage. Empty, which is the
/// default: nobody listens.
class Progress {
 public:
  class Stage;
  enum class Event { began, went_on, ended };
  /// Told when a stage begins and ends, and of every step, from any thread and by several at once. Its answer to a step
  /// is false when the work should stop. Must not throw.
  using Listener = std::function<bool(const Stage&, Event)>;

  Progress() = default;
  /// The stage of all work: it has no name.
  explicit Progress(Listener listener);

  /// A stage within this one, which ends with its last copy. `total`: its pieces; 0 when nobody knows.
  Progress stage(std::string name, std::uint64_t total) const;

  /// So many more pieces are done; from any thread. Throws Error(interrupted) when the listener wants the work to stop.
  void step(std::uint64_t pieces = 1) const;
  /// Throws as step: for loops within a piece, every few milliseconds.
  void check() const { step(0); }

  /// Pieces of this stage that are done; 0 where nobody listens.
  std::uint64_t done() const;

 private:
  std::shared_ptr<Stage> stage_;
};

class Progress::Stage {
 public:
  Stage(std::shared_ptr<const Listener> listener, std::shared_ptr<const Stage> around, std::string name,
        std::uint64_t total);
  Stage(const Stage&) = delete;
  ~Stage();

  const std::string& name() const { return name_; }
  std::uint64_t total() const { return total_; }  ///< 0: nobody knows
  std::uint64_t done() const { return done_; }
  const Stage* around() const { return around_.get(); }  ///< the stage that this one is within; null: all work

 private:
  friend class Progress;
  std::shared_ptr<const Listener> listener_;
  std::shared_ptr<const Stage> around_;
  std::string name_;
  std::uint64_t total_;
  std::atomic<std::uint64_t> done_ = 0;
};

}  // namespace welkin::base
