// SPDX-License-Identifier: Apache-2.0
// Opens .welkin files with the checks of runtime/format, and turns their refusals into Errors.
#pragma once

#include <span>
#include <string>

#include "format/container.h"
#include "format/sector_check.h"

namespace welkin::bake {

/// The file in `bytes`, which must stay alive. Throws Error(content) with `name` and the reason if it is of another
/// kind, or if `faultOf` finds a fault in it.
const format::File& openChecked(std::span<const std::byte> bytes, const std::string& name, format::Kind kind,
                                format::Fault (*faultOf)(const format::File&));

}  // namespace welkin::bake
