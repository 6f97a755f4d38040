// SPDX-License-Identifier: Apache-2.0
// JSON of files, and the exit status of exceptions of other libraries.
#include "sky/base/json_text.h"

#include <catch2/catch.hpp>
#include <filesystem>
#include <new>
#include <system_error>

#include "sky/base/failure.h"

namespace welkin::tests {

using Json = nlohmann::ordered_json;

TEST_CASE("JsonText, NestsUpToItsLimit") {
  for (const auto& [open, close] : {std::pair<std::string, std::string>("[", "]"), {"{\"a\":", "}"}})
    for (const int depth : {1, base::kDeepestJson, base::kDeepestJson + 1, 200000}) {
      INFO(open << " x " << depth);
      std::string text;
      for (int i = 0; i < depth; ++i) text += open;
      text += "1";
      for (int i = 0; i < depth; ++i) text += close;
      REQUIRE(base::parseJson(text).has_value() == (depth <= base::kDeepestJson));
    }
  std::string flat = "[";
  for (int i = 0; i < 100; ++i) flat += "[\"[[\\\"[\\\\\"],";
  REQUIRE(base::parseJson(flat + "1]").has_value());
  for (const char* text : {"", "[", "{\"a\"}", "\"\\ud800\"", "[1] 2", "nan", "\"\xff\""})
    REQUIRE_FALSE(base::parseJson(text).has_value());
}

TEST_CASE("JsonText, AFormIsMembersAndTypes") {
  const auto fits = [](const char* value, const char* example) {
    return base::hasForm(Json::parse(value), Json::parse(example));
  };
  CHECK(fits(R"({"b": 2, "a": 1})", R"({"a": 0})"));
  CHECK_FALSE(fits(R"({"b": 2})", R"({"a": 0})"));
  CHECK_FALSE(fits("[1]", R"({"a": 0})"));
  CHECK(fits("[1, 2, 3]", "[0]"));
  CHECK(fits("[]", "[0]"));
  CHECK_FALSE(fits("[1, \"2\"]", "[0]"));
  CHECK(fits("[1, 2.5]", "[0.0, 0.0]"));
  CHECK_FALSE(fits("[1]", "[0.0, 0.0]"));
  CHECK(fits("[{}, 1]", "[]"));
  CHECK_FALSE(fits("{}", "[]"));
  CHECK_FALSE(fits("-1", "0"));
  CHECK_FALSE(fits("1.5", "0"));
  CHECK(fits("-1", "0.5"));
  CHECK_FALSE(fits("null", "\"\""));
}

TEST_CASE("Failure, WhatARetryMayHelpIsStatus2") {
  using base::ExitStatus;
  const auto statusOf = [](const std::exception& e) { return base::errorOf(e).status(); };
  CHECK(statusOf(std::bad_alloc()) == ExitStatus::file);
  CHECK(statusOf(std::bad_array_new_length()) == ExitStatus::file);
  CHECK(statusOf(std::system_error(EAGAIN, std::generic_category())) == ExitStatus::file);
  CHECK(statusOf(std::filesystem::filesystem_error("x", std::error_code())) == ExitStatus::file);
  CHECK(statusOf(std::runtime_error("pthread_create has failed: Resource temporarily unavailable")) ==
        ExitStatus::file);
  CHECK(statusOf(std::logic_error("a fault")) == ExitStatus::internal);
  CHECK(std::string(base::errorOf(std::logic_error("a fault")).what()) == "internal error: a fault");
  CHECK(statusOf(base::Error(ExitStatus::content, "bad")) == ExitStatus::content);
}

}  // namespace welkin::tests
