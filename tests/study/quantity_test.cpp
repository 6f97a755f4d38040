// SPDX-License-Identifier: Apache-2.0
// Numbers in words, at the borders of their units.
#include "study/quantity.h"

#include <catch2/catch.hpp>

namespace welkin::study {
namespace {

TEST_CASE("InWords, Shares") {
  CHECK(inWords(1e-4, Quantity::share, 3) == "0.01 %");
  CHECK(inWords(0.003, Quantity::share, 3) == "0.3 %");
  CHECK(inWords(0.07, Quantity::share, 3) == "7 %");  // 7.000000000000001 by 100
  CHECK(inWords(1.0, Quantity::share, 3) == "100 %");
  CHECK(inWords(1e-8, Quantity::share, 3) == "1e-06 %");
  CHECK(inWords(0.0, Quantity::share, 3) == "0 %");
  CHECK(inWords(0.123456, Quantity::share, 3) == "12.3 %");
}

TEST_CASE("InWords, BytesByPowersOf1000") {
  CHECK(inWords(0.0, Quantity::bytes, 3) == "0");
  CHECK(inWords(999.0, Quantity::bytes, 3) == "999 B");
  CHECK(inWords(1000.0, Quantity::bytes, 3) == "1 KB");
  CHECK(inWords(1536.0, Quantity::bytes, 3) == "1.54 KB");
  CHECK(inWords(999950.0, Quantity::bytes, 3) == "1 MB");  // never 1000 KB
  CHECK(inWords(2e9, Quantity::bytes, 3) == "2 GB");
}

TEST_CASE("InWords, Times") {
  CHECK(inWords(2e-8, Quantity::seconds, 3) == "20 ns");
  CHECK(inWords(1e-6, Quantity::seconds, 3) == "1 us");
  CHECK(inWords(1e-3, Quantity::seconds, 3) == "1 ms");
  CHECK(inWords(0.0351, Quantity::seconds, 2) == "35 ms");
  CHECK(inWords(90.0, Quantity::seconds, 3) == "90 s");
  CHECK(inWords(5e-11, Quantity::seconds, 3) == "0.05 ns");
}

TEST_CASE("InWords, Numbers") {
  CHECK(inWords(-1234.5, Quantity::number, 3) == "-1230");
  CHECK(inWords(120000.0, Quantity::number, 3) == "120000");
  CHECK(inWords(1.2e7, Quantity::number, 3) == "1.2e+07");
  CHECK(inWords(0.5, Quantity::number, 3) == "0.5");
}

}  // namespace
}  // namespace welkin::study
