// SPDX-License-Identifier: Apache-2.0
// Commands that change the light of the picture, and compare two.
#pragma once

namespace welkin::view {

class Session;
class Words;

void shadeAction(Session& session, Words& words);
void otherAction(Session& session, Words& words);
void lightAction(Session& session, Words& words);
void compareAction(Session& session, Words& words);
void exposureAction(Session& session, Words& words);
void setAction(Session& session, Words& words);
void resetAction(Session& session, Words& words);

}  // namespace welkin::view
