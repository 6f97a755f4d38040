// SPDX-License-Identifier: Apache-2.0
// The results of a study as a folder of files: tables as CSV and JSON, charts as SVG and PNG, and a conclusion in
// words.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "study/chart.h"
#include "study/table.h"

namespace welkin::study {

struct StudyTable {
  std::string name;   ///< its files' name: a to z, 0 to 9, '_' and '-'; unique
  std::string title;  ///< above it in the conclusion
  Table table;
  bool in_conclusion = true;  ///< also written out there, which suits few rows
};

struct StudyChart {
  std::string name;  ///< as above, unique among the charts
  Chart chart;
};

struct StudyReport {
  std::string title;
  std::vector<std::string> paragraphs;  ///< Markdown, one paragraph each, before the charts and the tables
  std::vector<StudyChart> charts;
  std::vector<StudyTable> tables;
};

/// Writes NAME.csv and NAME.json of every table, NAME.svg and NAME.png of every chart, and last conclusion.md, which
/// shows them; makes the folder. The same report gives the same bytes. Returns the number of charts that are left out:
/// all of them without gnuplot, which conclusion.md then says. Throws Error(file) for the disk or a failing gnuplot.
/// Before anything is written it throws Error(internal) for a name that is no file name or is there twice, or for a
/// chart that drawChart refuses.
std::size_t writeReport(const StudyReport& report, const std::filesystem::path& folder);

}  // namespace welkin::study
