// SPDX-License-Identifier: Apache-2.0
#include "sky/bake/checked_file.h"

#include <fmt/format.h>

#include "sky/base/error.h"

namespace welkin::bake {
namespace {

std::string reasonOf(const format::Opened& opened, std::size_t size) {
  using format::Refusal;
  switch (opened.refusal) {
    case Refusal::misaligned:
      return "is not aligned in memory";
    case Refusal::foreign:
      return "is not a .welkin file";
    case Refusal::version:
      return fmt::format("is {} of version {}; this program reads {}: bake again", format::nameOf(opened.kind),
                         opened.found_version, format::versionOf(opened.kind));
    case Refusal::kind:
      return fmt::format("is a .welkin file of kind {}, which this program does not know",
                         static_cast<std::uint32_t>(opened.kind));
    case Refusal::header:
      return fmt::format("is damaged: its header states a size of {} bytes, must be {}", opened.found_header_size,
                         sizeof(format::Header));
    case Refusal::truncated:
      return fmt::format("has {} bytes where {} are expected", size, opened.expected_size);
    case Refusal::checksum:
      return "is damaged: its checksum does not fit";
    case Refusal::structure:
    case Refusal::none:
      break;
  }
  return "is damaged: its structure is not one";
}

}  // namespace

const format::File& openChecked(std::span<const std::byte> bytes, const std::string& name, format::Kind kind,
                                format::Fault (*faultOf)(const format::File&)) {
  const format::Opened opened = format::openContainer(bytes);
  if (opened.file == nullptr)
    throw base::Error(base::ExitStatus::content, fmt::format("{} {}", name, reasonOf(opened, bytes.size())));
  if (opened.kind != kind)
    throw base::Error(base::ExitStatus::content,
                      fmt::format("{} is {}, must be {}", name, format::nameOf(opened.kind), format::nameOf(kind)));
  if (const format::Fault fault = faultOf(*opened.file); fault.what != nullptr)
    throw base::Error(base::ExitStatus::content, fmt::format("{}: {} {}", name, fault.what, fault.must));
  return *opened.file;
}

}  // namespace welkin::bake
