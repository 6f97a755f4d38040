// SPDX-License-Identifier: Apache-2.0
// Text for messages: one line, and nothing that steers a terminal.
#include "sky/base/message.h"

#include <catch2/catch.hpp>

namespace welkin::tests {

TEST_CASE("Message, IsOneLineWithoutControls") {
  using base::oneLine;
  CHECK(oneLine("plain \\ text") == "plain \\ text");
  CHECK(oneLine("h\u00e9, \U0001f305") == "h\u00e9, \U0001f305");
  CHECK(oneLine("a\nb\r\nc\td\n\n") == "a\\nb\\r\\nc\\td");
  CHECK(oneLine("\x1b[31mred\x7f") == "\\x1b[31mred\\x7f");
  CHECK(oneLine(std::string_view("a\0b", 3)) == "a\\x00b");
  CHECK(oneLine("\u0085\u2028\u202e") == "\\u0085\\u2028\\u202e");
  CHECK(oneLine("").empty());
}

TEST_CASE("Message, BytesThatAreNoUtf8AreEscaped") {
  using base::oneLine;
  CHECK(oneLine("a\xff") == "a\\xff");
  CHECK(oneLine("\xc3") == "\\xc3");                             // cut
  CHECK(oneLine("\xc0\xaf") == "\\xc0\\xaf");                    // overlong
  CHECK(oneLine("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // a surrogate
  CHECK(oneLine("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // past U+10FFFF
  for (const char* text : {"a\xff\n", "\u202e", "\x1b"}) CHECK(oneLine(oneLine(text)) == oneLine(text));
}

TEST_CASE("Message, ShortenedTextKeepsItsCharactersWhole") {
  CHECK(base::shortened("abcdef", 6) == "abcdef");
  CHECK(base::shortened("abcdefg", 6) == "abc...");
  CHECK(base::shortened("ab\u00e9defg", 6) == "ab...");  // the third byte begins a character of two
}

}  // namespace welkin::tests
