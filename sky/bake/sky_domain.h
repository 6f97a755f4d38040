// SPDX-License-Identifier: Apache-2.0
// The domain of every parameter of sky.toml. The loader takes its ranges from here, docs/sky_file.md its table.
#pragma once

#include "sky/base/domain.h"

namespace welkin::bake {

/// Returns the rows in the order of the page.
const base::Domain& skyDomain();

}  // namespace welkin::bake
