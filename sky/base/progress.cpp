// SPDX-License-Identifier: Apache-2.0
#include "sky/base/progress.h"

#include "sky/base/error.h"

namespace welkin::base {

Progress::Stage::Stage(std::shared_ptr<const Listener> listener, std::shared_ptr<const Stage> around, std::string name,
                       std::uint64_t total)
    : listener_(std::move(listener)), around_(std::move(around)), name_(std::move(name)), total_(total) {
  (*listener_)(*this, Event::began);
}

Progress::Stage::~Stage() {
  (*listener_)(*this, Event::ended);
}

Progress::Progress(Listener listener)
    : stage_(std::make_shared<Stage>(std::make_shared<const Listener>(std::move(listener)), nullptr, "",
                                     std::uint64_t{0})) {}

Progress Progress::stage(std::string name, std::uint64_t total) const {
  Progress inner;
  if (stage_) inner.stage_ = std::make_shared<Stage>(stage_->listener_, stage_, std::move(name), total);
  return inner;
}

void Progress::step(std::uint64_t pieces) const {
  if (!stage_) return;
  stage_->done_ += pieces;
  if (!(*stage_->listener_)(*stage_, Event::went_on))
    throw Error(ExitStatus::interrupted, "interrupted; finished files are kept");
}

std::uint64_t Progress::done() const {
  return stage_ ? stage_->done() : 0;
}

}  // namespace welkin::base
