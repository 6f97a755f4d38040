// SPDX-License-Identifier: Apache-2.0
// A small but complete sky file: moon, cubemaps, gradients.
#pragma once

#include <cstddef>
#include <vector>

namespace welkin::tests {

const std::vector<std::byte>& smallFile();

}  // namespace welkin::tests
