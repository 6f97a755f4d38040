// SPDX-License-Identifier: Apache-2.0
#include "study/report.h"

#include <fmt/format.h>

#include <map>
#include <set>
#include <string_view>

#include "sky/base/atomic_file.h"
#include "sky/base/error.h"

namespace welkin::study {
namespace {

void checkName(const std::string& name, std::set<std::string>& taken) {
  constexpr std::string_view kAllowed = "abcdefghijklmnopqrstuvwxyz0123456789_-";
  if (name.empty() || name.find_first_not_of(kAllowed) != std::string::npos) {
    throw base::Error(base::ExitStatus::internal,
                      fmt::format("study: '{}' is no file name; allowed are a to z, 0 to 9, _ and -", name));
  }
  if (!taken.insert(name).second)
    throw base::Error(base::ExitStatus::internal, fmt::format("study: '{}' is there twice", name));
}

std::string conclusionOf(const StudyReport& report, std::size_t charts_left_out) {
  std::string text = fmt::format("# {}\n", report.title);
  for (const std::string& paragraph : report.paragraphs) text += fmt::format("\n{}\n", paragraph);
  if (charts_left_out > 0)
    text += fmt::format("\n{} charts were left out: gnuplot is not installed.\n", charts_left_out);
  else
    for (const StudyChart& chart : report.charts)
      text += fmt::format("\n![{}]({}.png)\n", chart.chart.title, chart.name);
  for (const StudyTable& table : report.tables) {
    text += fmt::format("\n## {}\n\n", table.title);
    if (table.in_conclusion) text += table.table.markdown() + '\n';
    text += fmt::format("All figures: [{0}.csv]({0}.csv), [{0}.json]({0}.json)\n", table.name);
  }
  return text;
}

}  // namespace

std::size_t writeReport(const StudyReport& report, const std::filesystem::path& folder) {
  std::set<std::string> tables;
  std::set<std::string> charts;
  std::map<std::string, std::string> files;
  std::size_t left_out = 0;
  for (const StudyTable& table : report.tables) {
    checkName(table.name, tables);
    files[table.name + ".csv"] = table.table.csv();
    files[table.name + ".json"] = table.table.json().dump(2) + "\n";
  }
  for (const StudyChart& chart : report.charts) {
    checkName(chart.name, charts);
    std::optional<ChartPictures> pictures = drawChart(chart.chart);
    if (!pictures) {
      ++left_out;
      continue;
    }
    files[chart.name + ".svg"] = std::move(pictures->svg);
    files[chart.name + ".png"] = std::move(pictures->png);
  }
  base::makeFolder(folder);
  for (const auto& [name, text] : files) base::writeFile(folder / name, text);
  base::writeFile(folder / "conclusion.md", conclusionOf(report, left_out));
  return left_out;
}

}  // namespace welkin::study
