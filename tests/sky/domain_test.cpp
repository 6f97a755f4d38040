// SPDX-License-Identifier: Apache-2.0
// Tests every parameter of the domain through the loader, at its edges and one unit in the last place to either side.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <optional>

#include "parameter_text.h"
#include "sky/bake/sky_domain.h"
#include "sky/bake/sky_file.h"
#include "sky/base/error.h"
#include "tests/folder.h"

namespace welkin::tests {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The loader's refusal of a parameter's number. Nothing if the loader accepts it.
std::optional<std::string> refusalOf(const Folder& folder, const base::Parameter& p, const std::string& number) {
  const std::string path = folder.write("sky.toml", fileText(p, valueText(p, number)));
  try {
    bake::readSkyFile(path);
  } catch (const base::Error& e) {
    REQUIRE(e.status() == base::ExitStatus::content);
    return e.what();
  }
  return std::nullopt;
}

bool isWhole(const base::Parameter& p) {
  return p.kind == base::Kind::whole_number || p.kind == base::Kind::hours;
}

bool hasRange(const base::Parameter& p) {
  return p.range.low != p.range.high && p.kind != base::Kind::image;
}

/// Whether a coefficient is refused for its effect on the sky and not for its own range.
bool isOfTheSky(const base::Parameter& p, const std::string& refusal) {
  return p.key == "luminance" && refusal.find("makes the luminance") != std::string::npos;
}

void requireRefused(const Folder& folder, const base::Parameter& p, double value) {
  const auto refusal = refusalOf(folder, p, numberText(value));
  REQUIRE(refusal);
  INFO(*refusal);
  CHECK_FALSE(isOfTheSky(p, *refusal));
  const std::string key = p.section.empty() ? "sky.intensity" : fmt::format("{}.{}", p.section, p.key);
  CHECK(refusal->find(folder / "sky.toml:") == 0);  // the file and the line
  CHECK(refusal->find(key + " = ") != std::string::npos);
  CHECK(refusal->find("must be") != std::string::npos);
  if (p.range.without_high) return;  // the message gives the other end alone
  CHECK(refusal->find(fmt::format("{} to {}", p.range.low, p.range.high)) != std::string::npos);
}

void requireAccepted(const Folder& folder, const base::Parameter& p, double value) {
  const auto refusal = refusalOf(folder, p, numberText(value));
  INFO(refusal.value_or(""));
  CHECK((!refusal || isOfTheSky(p, *refusal)));
}

}  // namespace

TEST_CASE("Domain, EveryEdgeAndTheNextNumberOnEitherSide") {
  const Folder folder;
  folder.write("stars.ppm", "P3 2 1 255  0 0 0  255 255 255");
  int rows = 0;
  for (const base::Parameter& p : bake::skyDomain()) {
    if (!hasRange(p)) continue;
    ++rows;
    const auto step = [&](double value, double towards) {
      return isWhole(p) ? value + (towards > value ? 1.0 : -1.0) : std::nextafter(value, towards);
    };
    CAPTURE(p.section, p.key, p.part);
    requireAccepted(folder, p, p.range.low);
    if (p.key != "cubemap_size") requireAccepted(folder, p, step(p.range.low, kInfinity));
    requireRefused(folder, p, step(p.range.low, -kInfinity));
    if (p.range.without_high) {
      requireRefused(folder, p, p.range.high);
    } else {
      requireAccepted(folder, p, p.range.high);
      requireRefused(folder, p, step(p.range.high, kInfinity));
    }
    requireAccepted(folder, p, step(p.range.high, -kInfinity));
  }
  REQUIRE(rows > 30);
}

TEST_CASE("Domain, NeverANumberThatIsNone") {
  const Folder folder;
  folder.write("stars.ppm", "P3 2 1 255  0 0 0  255 255 255");
  for (const base::Parameter& p : bake::skyDomain()) {
    if (!hasRange(p)) continue;
    for (const char* none : {"nan", "-nan", "inf", "-inf", "\"1\"", "true", "1979-05-27", "[]", "{}"}) {
      CAPTURE(p.section, p.key, p.part, none);
      CHECK(refusalOf(folder, p, none));
    }
  }
}

TEST_CASE("Domain, DefaultsLieInTheirRangeAndAreAccepted") {
  const Folder folder;
  for (const base::Parameter& p : bake::skyDomain()) {
    CAPTURE(p.section, p.key, p.part);
    if (const auto* number = std::get_if<double>(&p.otherwise)) {
      CHECK(p.range.contains(*number));
      if (p.section != "stars") CHECK_FALSE(refusalOf(folder, p, numberText(*number)));
    }
    if (const auto* word = std::get_if<std::string_view>(&p.otherwise); word != nullptr && !p.words.empty()) {
      CHECK(std::find(p.words.begin(), p.words.end(), *word) != p.words.end());
      for (const auto each : p.words) CHECK_FALSE(refusalOf(folder, p, fmt::format("\"{}\"", each)));
    }
  }
}

TEST_CASE("Domain, NumbersOfKeysAndColoursAreCheckedOneByOne") {
  const Folder folder;
  const auto refused = [&](const base::Parameter& p, const std::string& value) {
    const std::string path = folder.write("sky.toml", fileText(p, value));
    try {
      bake::readSkyFile(path);
    } catch (const base::Error&) {
      return true;
    }
    return false;
  };
  for (const base::Parameter& p : bake::skyDomain()) {
    if (p.section == "stars") continue;
    const std::string good = numberText(p.range.low + 0.25 * std::min(1.0, p.range.high - p.range.low));
    const std::string bad = numberText(std::nextafter(p.range.high, kInfinity));
    CAPTURE(p.section, p.key, good, bad);
    if (p.kind == base::Kind::number_or_keys) {
      CHECK_FALSE(refused(p, fmt::format("[[0, {0}], [23.5, {0}]]", good)));
      CHECK(refused(p, fmt::format("[[0, {0}], [23.5, {1}]]", good, bad)));
    } else if (p.kind == base::Kind::colour_or_keys || p.kind == base::Kind::tint) {
      CHECK_FALSE(refused(p, fmt::format("[[0, [{0}, {0}, {0}]], [1, [{0}, {0}, {0}]]]", good)));
      CHECK(refused(p, fmt::format("[[0, [{0}, {0}, {0}]], [1, [{0}, {0}, {1}]]]", good, bad)));
    } else if (p.kind == base::Kind::colour || p.kind == base::Kind::gradient) {
      CHECK(refused(p, fmt::format("[{1}, {0}, {0}]", good, bad)));
      CHECK(refused(p, fmt::format("[{0}, {0}, {1}]", good, bad)));
    } else if (p.kind == base::Kind::hours) {
      CHECK_FALSE(refused(p, "[0, 23.9999]"));
      for (const char* list : {"[0, 24]", "[0, 0]", "[-1e-300]", "[3, 2]", "[nan]"}) CHECK(refused(p, list));
    }
  }
}

TEST_CASE("Domain, ParameterOfFindsItsRow") {
  for (const base::Parameter& p : bake::skyDomain())
    CHECK(&base::parameterOf(bake::skyDomain(), p.section, p.key, p.part) == &p);
  CHECK_THROWS_AS(base::parameterOf(bake::skyDomain(), "sky", "brightness"), std::logic_error);
}

}  // namespace welkin::tests
