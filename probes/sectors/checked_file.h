// SPDX-License-Identifier: Apache-2.0
// The .welkin files of a level, opened with the checks of runtime/format, whose refusals become Errors.
#pragma once

#include <span>
#include <string>

#include "format/container.h"
#include "format/sector_check.h"

namespace welkin::sectors {

/// The file in `bytes`, which stay and whose content `faultOf` finds no fault with. Throws Error(content) with `name`
/// and the reason.
const format::File& openChecked(std::span<const std::byte> bytes, const std::string& name,
                                format::Fault (*faultOf)(const format::File&));

}  // namespace welkin::sectors
