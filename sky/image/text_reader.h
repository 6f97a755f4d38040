// SPDX-License-Identifier: Apache-2.0
// The part that readers of formats with a header of text share.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "sky/base/error.h"

namespace welkin::image {

/// A picture's bytes that have not been read yet, and errors that name its file. The name and the bytes must outlive
/// it.
class TextReader {
 public:
  TextReader(const std::string& name, std::span<const std::byte> bytes)
      : text_(reinterpret_cast<const char*>(bytes.data()), bytes.size()), name_(name) {}

  base::Error refusal(const std::string& why) const {
    return {base::ExitStatus::content, fmt::format("{}: {}", name_, why)};
  }

 protected:
  std::string_view text_;

 private:
  const std::string& name_;
};

}  // namespace welkin::image
