// SPDX-License-Identifier: Apache-2.0
// The third and fourth axes of a study: encodings of the numbers, and the gain of an error budget. All complete tables
// that were measured, their Pareto front, and the plan of a bake for each budget.
#pragma once

#include "sky/table/plan.h"
#include "study/measure_representations.h"

namespace welkin::study {

/// One encoding at even keys.
struct EncodingRow {
  std::string representation;
  table::Encoding encoding;
  std::size_t keys = 0;
  std::size_t bytes = 0;
  double encoding_error = 0.0;  ///< by rounding alone
  double error = 0.0;           ///< by everything
};

/// A complete table: a representation, placed keys, an encoding.
struct MeasuredTable {
  std::string name;
  std::size_t keys = 0;
  std::size_t bytes = 0;
  double error = 0.0;
  bool is_modes = false;
  bool is_fitted = false;
};

/// The plan of table::planDay for a budget.
struct BudgetRow {
  double max_error = 0.0;
  table::DayPlan plan;
  double plan_s = 0.0;
};

inline constexpr double kBudgets[] = {0.1, 0.03, 0.01, 0.003};

struct TableStudy {
  std::vector<EncodingRow> encodings;
  std::vector<MeasuredTable> tables;
  std::vector<std::size_t> front;  ///< indices of tables, bytes rising
  std::vector<BudgetRow> budgets;
};

std::vector<EncodingRow> measureEncodings(const StudyDay& day, const std::vector<Candidate>& candidates);
std::vector<MeasuredTable> measureTables(const StudyDay& day, const std::vector<Candidate>& candidates,
                                         const StudyOptions& options);
std::vector<BudgetRow> measureBudgets(const StudyDay& day, const StudyOptions& options);
/// Adds the tables of the budgets that were met to all tables.
void addPlans(TableStudy& study);
std::vector<std::size_t> frontOf(const std::vector<MeasuredTable>& tables);

/// Adds the tables "encodings", "pareto", "tables" and "budgets" and the charts "pareto" and "encodings".
void reportTables(const TableStudy& study, StudyReport& report);

}  // namespace welkin::study
