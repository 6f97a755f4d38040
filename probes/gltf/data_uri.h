// SPDX-License-Identifier: Apache-2.0
// The bytes of a data URI, and the path that another URI stands for.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace welkin::gltf {

/// Whether a URI holds its bytes itself.
bool isDataUri(std::string_view uri);

/// The bytes of a data URI in base64 (RFC 2397, RFC 4648). Padding may be missing. `what` begins the message. Throws
/// Error(content) if it is not base64 or has a character or a length that base64 has not. The time is linear.
std::vector<unsigned char> dataUriBytes(std::string_view uri, const std::string& what);

/// A URI with each %41 replaced by its byte.
std::string withoutPercents(std::string_view uri);

}  // namespace welkin::gltf
