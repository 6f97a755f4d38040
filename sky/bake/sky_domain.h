// SPDX-License-Identifier: Apache-2.0
// The domain of every parameter of sky.toml. Its loader takes ranges from here, the page docs/sky_file.md its table.
#pragma once

#include "sky/base/domain.h"

namespace welkin::bake {

/// The rows in the order of the page.
const base::Domain& skyDomain();

}  // namespace welkin::bake
