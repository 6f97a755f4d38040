// SPDX-License-Identifier: Apache-2.0
// The domain of every parameter of level.toml. The loaders take their ranges from here, and docs/level_file.md its
// table.
#pragma once

#include "sky/base/domain.h"

namespace welkin::level {

/// The parameters in the order of the page.
const base::Domain& levelDomain();

}  // namespace welkin::level
