// SPDX-License-Identifier: Apache-2.0
// The domain of every parameter of level.toml. Its loaders take their ranges from here, the page docs/level_file.md its
// table.
#pragma once

#include "sky/base/domain.h"

namespace welkin::level {

/// In the order of the page.
const base::Domain& levelDomain();

}  // namespace welkin::level
