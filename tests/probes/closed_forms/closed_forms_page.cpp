// SPDX-License-Identifier: Apache-2.0
// Prints the closed forms of closed_form_list.h in three columns.
//   closed_forms                  prints the tables of docs/closed_forms.md
//   closed_forms --write PAGE     puts them into the page
// Exit status 1 when a column is off by more than its stated bound.
#include <fmt/format.h>

#include <string_view>

#include "closed_form_columns.h"
#include "tests/page.h"

namespace welkin::tests {
namespace {

constexpr std::size_t kPaths = 65536;

constexpr double kNothing = 5e-6;  ///< half of the last digit that is printed

/// Text of the first channel, whose albedo is in the form's name.
std::string measuredText(const Compared& c) {
  return c.standard_error.x < kNothing ? fmt::format("{:.5f}", c.found.x)
                                       : fmt::format("{:.5f} +- {:.5f}", c.found.x, c.standard_error.x);
}

std::string lostText(const Compared& c) {
  return std::abs(c.lost.x) < kNothing ? "0" : fmt::format("{:+.5f}", c.lost.x);
}

struct Tables {
  std::string forms =
      "| form | bounces | normal | exact | path tracer | transfer of this direction | inherent error | four directions "
      "| inherent error |\n|---|---|---|---|---|---|---|---|---|\n";
  std::string dark = "| level | normals | path tracer | transfer | four directions |\n|---|---|---|---|---|\n";
  std::size_t compared = 0;
  bool agree = true;
};

void add(const ClosedForm& form, Tables& tables) {
  const ClosedFormColumns columns = columnsOf(form, kPaths);
  const auto look = [&](const auto& list) {
    double largest = 0.0;
    for (const Compared& c : list) {
      tables.agree = tables.agree && agrees(form, c);
      ++tables.compared;
      for (int i = 0; i < 3; ++i) largest = std::max(largest, std::abs(c.found[i]));
    }
    return largest;
  };
  const double found[3] = {look(columns.path_tracer), look(columns.transfer), look(columns.four_directions)};
  const std::size_t asked = form.asked.size();
  if (form.exact({0, 1, 0}) == Number3(0.0) && form.exact({0, -1, 0}) == Number3(0.0)) {
    tables.dark += fmt::format("| {} | {} | {:g} | {:g} | {:g} |\n", form.name, columns.path_tracer.size(), found[0],
                               found[1], found[2]);
    return;
  }
  const auto row = [&](const std::string& normal, const Compared& path, const std::string& rest) {
    tables.forms += fmt::format("| {} | {} | {} | {:.5f} | {} | {} |\n", form.name, form.bounces, normal,
                                path.expected.x, measuredText(path), rest);
  };
  for (std::size_t i = 0; i < asked; ++i) {
    const Compared& four = columns.four_directions[i];
    row(form.asked[i].name, columns.path_tracer[i], fmt::format("| | {} | {}", measuredText(four), lostText(four)));
  }
  for (const std::size_t b : form.shown) {
    const Compared& own = columns.transfer[b];
    row(b == 3 ? "down" : fmt::format("B{}", b + 1), columns.path_tracer[asked + b],
        fmt::format("{} | {} | |", measuredText(own), lostText(own)));
  }
}

}  // namespace
}  // namespace welkin::tests

int main(int count, char** arguments) {
  using namespace welkin::tests;
  Tables tables;
  const auto forms = closedForms();
  for (const ClosedForm& form : forms) add(form, tables);
  const std::string text = fmt::format(
      "{} forms, {} comparisons in three channels, {} paths each; {}.\n\n{}\n{}", forms.size(), tables.compared, kPaths,
      tables.agree ? "all within three standard errors and their stated bounds" : "NOT ALL AGREE", tables.forms,
      tables.dark);
  if (count == 3 && std::string_view(arguments[1]) == "--write") {
    if (bringUpToDate(arguments[2], "forms", text, true) != 0) return 1;
  } else {
    fmt::print("{}", text);
  }
  return tables.agree ? 0 : 1;
}
