// SPDX-License-Identifier: Apache-2.0
// Words of the viewer's commands.
#include "view/words.h"

#include <catch2/catch.hpp>
#include <functional>

#include "sky/base/error.h"

using namespace welkin;
using view::Words;

namespace {

std::string refusalOf(const std::vector<std::string>& words, const std::function<void(Words&)>& read) {
  try {
    Words reader(words);
    read(reader);
  } catch (const base::Error& error) {
    CHECK(error.status() == base::ExitStatus::content);
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("Words, BlanksQuotesAndComments") {
  using List = std::vector<std::string>;
  CHECK(view::wordsOf("").empty());
  CHECK(view::wordsOf(" \t# time 9").empty());
  CHECK(view::wordsOf("time 9.5\r") == List{"time", "9.5"});
  CHECK(view::wordsOf("  set  tint\toff # as the artist wants") == List{"set", "tint", "off"});
  CHECK(view::wordsOf("screenshot \"a picture #1.png\"") == List{"screenshot", "a picture #1.png"});
  CHECK(view::wordsOf("screenshot \"\"") == List{"screenshot", ""});
  CHECK_THROWS_AS(view::wordsOf("screenshot \"a"), base::Error);
}

TEST_CASE("Words, NumbersInTheirRange") {
  const std::vector<std::string> words{"time", "9.5", "3", "-0.25"};
  Words reader(words);
  CHECK(reader.number("the hour", 0.0, 24.0) == 9.5);
  CHECK(reader.count("paths", 1, 8) == 3);
  CHECK(!reader.done());
  CHECK(reader.number("x", -1.0, 1.0) == -0.25);
  CHECK(reader.done());
  reader.end();
}

TEST_CASE("Words, RefusalsNameWordAndWhatIsAllowed") {
  const auto hour = [](Words& w) { w.number("the hour", 0.0, 24.0); };
  for (const char* word : {"noon", "25", "-1", "nan", "inf", "9,5", "9.5h", "", "1e999"})
    CHECK(refusalOf({"time", word}, hour) ==
          std::string("time: the hour is \"") + word + "\", must be a number in 0 to 24");
  CHECK(refusalOf({"time"}, hour) == "time: the hour is missing: a number in 0 to 24");
  CHECK(refusalOf({"paths", "2.5"}, [](Words& w) { w.count("the number of paths", 1, 9); }) ==
        "paths: the number of paths is \"2.5\", must be a whole number in 1 to 9");
  CHECK(refusalOf({"bounds", "yes"}, [](Words& w) { w.isOn("bounds"); }) ==
        "bounds: bounds is \"yes\", must be one of off, on");
  CHECK(refusalOf({"reset", "all"}, [](Words& w) { w.end(); }) == "reset: \"all\" is one word too many");
}
