// SPDX-License-Identifier: Apache-2.0
// Counts what this program and the libraries in it allocate by operator new. Sanitizers replace it, and nothing is
// counted.
#pragma once

#include <cstddef>

namespace welkin::tests {

/// Calls of operator new so far.
std::size_t allocationCount();

}  // namespace welkin::tests
