// SPDX-License-Identifier: Apache-2.0
// Commands that edit level.toml and bake it again.
#pragma once

namespace welkin::view {

class Session;
class Words;

void probeAction(Session& session, Words& words);
void roomAction(Session& session, Words& words);
void editAction(Session& session, Words& words);
void saveAction(Session& session, Words& words);
void recoverAction(Session& session, Words& words);
void discardAction(Session& session, Words& words);
void rebakeAction(Session& session, Words& words);
void cancelAction(Session& session, Words& words);
/// The rest of `wait`: "rebake" until none is at work, "sector" until one more sector is shown, or nothing.
void waitAction(Session& session, Words& words);

}  // namespace welkin::view
