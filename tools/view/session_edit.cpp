// SPDX-License-Identifier: Apache-2.0
// The part of a session that edits level.toml and bakes it again.
#include "probes/geometry/sector_name.h"
#include "sky/base/atomic_file.h"
#include "sky/base/error.h"
#include "view/session.h"

namespace welkin::view {

void Session::edited() {
  text_ = std::make_shared<const std::string>(edits_.text());
  if (state_.hand && *state_.hand >= edits_.placed().probes.size()) state_.hand.reset();
  ++version_;
}

void Session::edit(const std::string& text) {
  const Undoable before = now();
  try {
    edits_.set(text);
  } catch (const base::Error&) {  // the text may be replaced and its journal not written
    if (edits_.text() == *before.level) throw;
    history_.record(before, false);
    edited();
    throw;
  }
  history_.record(before, false);
  edited();
}

void Session::save() {
  edits_.save();
  ++version_;
}

void Session::recover() {
  const Undoable before = now();
  edits_.recover();
  history_.record(before, false);
  edited();
}

void Session::discard() {
  const Undoable before = now();
  edits_.discard();
  if (edits_.text() != *before.level) history_.record(before, false);
  edited();
}

void Session::openOther(const std::string& folder) {
  painter_.openOther(folder);
  picture_.reset();
  error_.reset();
  ++version_;
}

void Session::rebake(const std::string& sectors) {
  if (rebake_) throw base::Error(base::ExitStatus::content, "rebake: one is at work already; `cancel` ends it");
  edits_.save();
  rebake_ = std::make_unique<Rebake>(level_.files().level, level_.files().folder, sectors);
  status_.emplace();
  ++version_;
}

void Session::cancelRebake() {
  if (!rebake_) return;
  rebake_.reset();
  const bool shown = !status_->finished.empty();
  status_->state = RebakeState::cancelled;
  status_->finished.clear();
  if (shown) reload(false);
  ++version_;
}

void Session::reload(bool finished) {
  std::map<geometry::SectorId, std::vector<std::byte>> instead;
  if (finished)
    for (const geometry::SectorId id : status_->finished)
      instead.emplace(id, base::readFile(rebake_->copy() / "sectors" / geometry::fileNameOf(id)));
  painter_.forgetLevel();
  level_.reload(instead);
  picture_.reset();
  error_.reset();
  answer_.reset();
  probe_.reset();
  if (state_.probe) {
    const sectors::SectorFile* sector = level_.sector(state_.probe->sector);
    if (sector == nullptr || state_.probe->number >= sector->probes.probes()) state_.probe.reset();
  }
  ++version_;
}

void Session::advance() {
  if (!rebake_) return;
  RebakeStatus now = rebake_->status();
  const std::size_t shown = status_->finished.size();
  const bool more = now.finished.size() > shown;
  status_ = now;
  if (now.state == RebakeState::running) {
    try {
      if (more) reload(true);
    } catch (const base::Error&) {  // sectors of both bakes need not go together: then the end shows the new ones
      reload(false);
    }
    return;
  }
  if (now.state == RebakeState::done) {
    try {
      rebake_->take();
      baked_text_ = edits_.unsaved() ? std::string() : edits_.text();
    } catch (const base::Error& error) {
      status_->state = RebakeState::failed;
      status_->message = error.what();
    }
  }
  if (status_->state != RebakeState::done) status_->finished.clear();
  rebake_.reset();
  reload(false);
}

}  // namespace welkin::view
