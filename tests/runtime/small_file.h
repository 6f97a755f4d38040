// SPDX-License-Identifier: Apache-2.0
// A small but complete sky file: moon, cubemaps, gradients.
#pragma once

#include <cstddef>
#include <vector>

namespace welkin::tests {

const std::vector<std::byte>& smallFile();

/// A regular expression of a message about a file that is not there, in the words of POSIX, Wine and Windows.
inline constexpr const char* kMissingFile = ".*: (No such file or directory|.*not found[.]|.*cannot find.*)";

}  // namespace welkin::tests
