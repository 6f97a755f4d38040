// SPDX-License-Identifier: Apache-2.0
// A table of measurements, and how it is written: CSV (RFC 4180), JSON, Markdown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "study/quantity.h"

namespace welkin::study {

/// A column: names are unique within a table. CSV and JSON hold its numbers as they are, Markdown by `quantity`.
struct TableColumn {
  std::string name;
  std::string unit = {};  ///< as CSV and JSON state it, for example "bytes"; empty for a number or words
  Quantity quantity = Quantity::number;
};

/// Nothing (not measured), a finite number or words.
using Cell = std::variant<std::monostate, double, std::string>;

class Table {
 public:
  /// Throws Error(internal) for no columns or two of one name.
  explicit Table(std::vector<TableColumn> columns);

  /// Throws Error(internal) naming the column for a number that is not finite, or for another count than the columns'.
  void addRow(std::vector<Cell> cells);

  const std::vector<TableColumn>& columns() const { return columns_; }
  const std::vector<std::vector<Cell>>& rows() const { return rows_; }

  /// A header of `name (unit)`, then the rows; lines end with CR LF. Numbers are the shortest that read back exactly.
  std::string csv() const;

  /// {"columns": [{"name", "unit"}], "rows": [{name: value}]}; a value that was not measured is null.
  nlohmann::ordered_json json() const;

  /// Numbers with at most `digits` significant digits, to the right; words to the left.
  std::string markdown(int digits = 3) const;

 private:
  std::vector<TableColumn> columns_;
  std::vector<std::vector<Cell>> rows_;
};

}  // namespace welkin::study
