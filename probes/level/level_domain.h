// SPDX-License-Identifier: Apache-2.0
// The domain of every parameter of level.toml. Its loaders take their ranges from here, the page docs/level_file.md its
// table.
#pragma once

#include "sky/domain.h"

namespace welkin::probes {

/// In the order of the page.
const sky::Domain& levelDomain();

}  // namespace welkin::probes
