// SPDX-License-Identifier: Apache-2.0
#include "probes/gltf/data_uri.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>

#include "sky/base/error.h"
#include "sky/base/message.h"

namespace welkin::gltf {
namespace {

constexpr std::uint8_t kForeign = 255;

constexpr std::array<std::uint8_t, 256> digitValues() {
  std::array<std::uint8_t, 256> value{};
  for (auto& v : value) v = kForeign;
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < kDigits.size(); ++i)
    value[static_cast<unsigned char>(kDigits[i])] = static_cast<std::uint8_t>(i);
  return value;
}

constexpr std::array<std::uint8_t, 256> kValue = digitValues();

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const char lower = static_cast<char>(c | 0x20);
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

}  // namespace

bool isDataUri(std::string_view uri) {
  return uri.starts_with("data:");
}

std::vector<unsigned char> dataUriBytes(std::string_view uri, const std::string& what) {
  const auto refuse = [&](const std::string& why) {
    return base::Error(base::ExitStatus::content, fmt::format("{}: {}", what, why));
  };
  const std::size_t comma = uri.substr(0, 200).find(',');
  if (comma == std::string_view::npos || !uri.substr(0, comma).ends_with(";base64"))
    throw refuse(fmt::format("its data URI begins \"{}\": must be data:TYPE;base64,",
                             base::shortened(base::oneLine(uri.substr(0, 60)), 40)));
  std::string_view digits = uri.substr(comma + 1);
  for (int i = 0; i < 2 && digits.ends_with('='); ++i) digits.remove_suffix(1);
  if (digits.size() % 4 == 1) throw refuse("its data URI is cut: base64 has no such length");
  std::vector<unsigned char> bytes;
  bytes.reserve(digits.size() / 4 * 3 + 2);
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = 0; i < digits.size(); ++i) {
    const std::uint8_t value = kValue[static_cast<unsigned char>(digits[i])];
    if (value == kForeign)
      throw refuse(fmt::format("character {} of the base64 in its data URI is \"{}\"", i,
                               base::oneLine(std::string_view(&digits[i], 1))));
    bits = bits << 6 | value;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> count & 0xffU));
  }
  return bytes;
}

std::string withoutPercents(std::string_view uri) {
  std::string path;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    const int high = uri[i] == '%' && i + 2 < uri.size() ? hexDigit(uri[i + 1]) : -1;
    const int low = high >= 0 ? hexDigit(uri[i + 2]) : -1;
    if (low < 0) {
      path += uri[i];
      continue;
    }
    path += static_cast<char>(16 * high + low);
    i += 2;
  }
  return path;
}

}  // namespace welkin::gltf
