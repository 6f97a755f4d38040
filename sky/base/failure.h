// SPDX-License-Identifier: Apache-2.0
// The meaning of an exception to a user: the one place that gives exceptions of other libraries an exit status.
#pragma once

#include <exception>

#include "sky/base/error.h"

namespace welkin::base {

/// The error itself, or that of another exception: `file`, as a retry may help, where memory, a thread or a file was
/// refused; else `internal`.
Error errorOf(const std::exception& exception);

}  // namespace welkin::base
