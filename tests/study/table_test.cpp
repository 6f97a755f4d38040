// SPDX-License-Identifier: Apache-2.0
// Tables of measurements as CSV, JSON and Markdown.
#include "study/table.h"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

Table sample() {
  Table table({{"model", ""}, {"size", "bytes", Quantity::bytes}, {"error", "of 1", Quantity::share}, {"bands", ""}});
  table.addRow({"cie-12", 1536.0, 0.0625, 3.0});
  table.addRow({"a \"b\", c|d", 1000.0, std::monostate{}, 2.0});
  return table;
}

TEST_CASE("Table, CsvQuotesByRfc4180") {
  CHECK(sample().csv() ==
        "model,size (bytes),error (of 1),bands\r\n"
        "cie-12,1536,0.0625,3\r\n"
        "\"a \"\"b\"\", c|d\",1000,,2\r\n");
}

TEST_CASE("Table, CsvQuotesLineEndsAndHeaders") {
  Table table(std::vector<TableColumn>{{"a,b", "c\"d"}});
  table.addRow({"two\r\nlines"});
  CHECK(table.csv() == "\"a,b (c\"\"d)\"\r\n\"two\r\nlines\"\r\n");
}

TEST_CASE("Table, NumbersReadBackExactly") {
  for (const double number : {0.1, 1.0 / 3.0, 5e-324, std::numeric_limits<double>::max(), -0.007, 123456789.0}) {
    Table table(std::vector<TableColumn>{{"x", ""}});
    table.addRow({number});
    const std::string csv = table.csv();
    CHECK(std::strtod(csv.c_str() + csv.find('\n') + 1, nullptr) == number);
    CHECK(nlohmann::ordered_json::parse(table.json().dump())["rows"][0]["x"].get<double>() == number);
  }
}

TEST_CASE("Table, JsonKeepsTheOrderOfColumns") {
  CHECK(sample().json().dump() ==
        R"({"columns":[{"name":"model","unit":""},{"name":"size","unit":"bytes"},{"name":"error","unit":"of 1"},)"
        R"({"name":"bands","unit":""}],"rows":[{"model":"cie-12","size":1536.0,"error":0.0625,"bands":3.0},)"
        R"({"model":"a \"b\", c|d","size":1000.0,"error":null,"bands":2.0}]})");
}

TEST_CASE("Table, MarkdownIsInWords") {
  CHECK(sample().markdown() ==
        "| model | size | error | bands |\n"
        "|---|---:|---:|---:|\n"
        "| cie-12 | 1.54 KB | 6.25 % | 3 |\n"
        "| a \"b\", c\\|d | 1 KB | | 2 |\n");
}

TEST_CASE("Table, RefusesWhatItCannotHold") {
  CHECK_THROWS_AS(Table(std::vector<TableColumn>{}), base::Error);
  CHECK_THROWS_AS(Table(std::vector<TableColumn>{{"x", ""}, {"x", "m"}}), base::Error);
  Table table({{"x", ""}, {"y", ""}});
  CHECK_THROWS_AS(table.addRow({1.0}), base::Error);
  CHECK_THROWS_WITH(table.addRow({1.0, std::nan("")}), Catch::Contains("'y' of row 0 is nan"));
  CHECK_THROWS_AS(table.addRow({std::numeric_limits<double>::infinity(), 1.0}), base::Error);
  CHECK(table.rows().empty());
}

}  // namespace
}  // namespace welkin::study
