// SPDX-License-Identifier: Apache-2.0
#include "study/table.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>
#include <utility>

#include "sky/base/error.h"

namespace welkin::study {
namespace {

std::string quotedForCsv(const std::string& field) {
  if (field.find_first_of(",\"\r\n") == std::string::npos) return field;
  std::string quoted = "\"";
  for (const char c : field) quoted.append(c == '"' ? 2 : 1, c);
  return quoted + '"';
}

std::string escapedForMarkdown(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '|' || c == '\\') escaped += '\\';
    escaped += c == '\n' || c == '\r' ? ' ' : c;
  }
  return escaped;
}

std::string headerOf(const TableColumn& column) {
  return column.unit.empty() ? column.name : fmt::format("{} ({})", column.name, column.unit);
}

}  // namespace

Table::Table(std::vector<TableColumn> columns) : columns_(std::move(columns)) {
  if (columns_.empty()) throw base::Error(base::ExitStatus::internal, "table: it has no columns");
  std::set<std::string_view> names;
  for (const TableColumn& column : columns_) {
    if (!names.insert(column.name).second) {
      throw base::Error(base::ExitStatus::internal, fmt::format("table: two columns are named '{}'", column.name));
    }
  }
}

void Table::addRow(std::vector<Cell> cells) {
  if (cells.size() != columns_.size()) {
    throw base::Error(base::ExitStatus::internal,
                      fmt::format("table: a row of {} cells for {} columns", cells.size(), columns_.size()));
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const double* number = std::get_if<double>(&cells[i]);
    if (number != nullptr && !std::isfinite(*number)) {
      throw base::Error(base::ExitStatus::internal, fmt::format("table: '{}' of row {} is {}; a number must be finite",
                                                                columns_[i].name, rows_.size(), *number));
    }
  }
  rows_.push_back(std::move(cells));
}

std::string Table::csv() const {
  std::string text;
  for (const TableColumn& column : columns_) {
    if (!text.empty()) text += ',';
    text += quotedForCsv(headerOf(column));
  }
  text += "\r\n";
  for (const std::vector<Cell>& row : rows_) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) text += ',';
      if (const double* number = std::get_if<double>(&row[i])) text += fmt::format("{}", *number);
      if (const std::string* words = std::get_if<std::string>(&row[i])) text += quotedForCsv(*words);
    }
    text += "\r\n";
  }
  return text;
}

nlohmann::ordered_json Table::json() const {
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  for (const TableColumn& column : columns_) columns.push_back({{"name", column.name}, {"unit", column.unit}});
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const std::vector<Cell>& row : rows_) {
    nlohmann::ordered_json object = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < row.size(); ++i) {
      nlohmann::ordered_json& value = object[columns_[i].name];
      if (const double* number = std::get_if<double>(&row[i])) value = *number;
      if (const std::string* words = std::get_if<std::string>(&row[i])) value = *words;
    }
    rows.push_back(std::move(object));
  }
  return {{"columns", std::move(columns)}, {"rows", std::move(rows)}};
}

std::string Table::markdown(int digits) const {
  std::string text = "|";
  for (const TableColumn& column : columns_) {
    const bool said = column.quantity != Quantity::number;  // the cells have the unit
    text += fmt::format(" {} |", escapedForMarkdown(said ? column.name : headerOf(column)));
  }
  text += "\n|";
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const bool words =
        std::ranges::any_of(rows_, [&](const auto& row) { return std::holds_alternative<std::string>(row[i]); });
    text += words ? "---|" : "---:|";
  }
  for (const std::vector<Cell>& row : rows_) {
    text += "\n|";
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (const double* number = std::get_if<double>(&row[i])) {
        text += fmt::format(" {} |", inWords(*number, columns_[i].quantity, digits));
      } else if (const std::string* words = std::get_if<std::string>(&row[i])) {
        text += fmt::format(" {} |", escapedForMarkdown(*words));
      } else {
        text += " |";
      }
    }
  }
  return text + "\n";
}

}  // namespace welkin::study
