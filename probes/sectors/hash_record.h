// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "sky/base/hash.h"
#include "welkin_generated.h"

namespace welkin::sectors {

/// A hash as the files of a level hold it, and back.
inline format::Hash encode(const base::Hash128& hash) {
  return {hash.low, hash.high};
}
inline base::Hash128 decode(const format::Hash& hash) {
  return {hash.low(), hash.high()};
}

}  // namespace welkin::sectors
