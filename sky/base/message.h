// SPDX-License-Identifier: Apache-2.0
// Text for messages. A message is one line, and names from files cannot steer a terminal.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace welkin::base {

/// The text as one line of valid UTF-8. Control characters, line breaks, marks that turn the direction of writing and
/// bytes that are no UTF-8 become escapes, such as \n, \x1b and \u202e. White space at the end is cut. A second call
/// changes nothing.
std::string oneLine(std::string_view text);

/// The text, or its first characters and "..." if it has more than `most_bytes`. No character of UTF-8 is cut in two.
std::string shortened(std::string_view text, std::size_t most_bytes);

}  // namespace welkin::base
