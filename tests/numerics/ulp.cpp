// SPDX-License-Identifier: Apache-2.0
// Compares float with double, and the GPU with both: the largest error of every shared formula and its arguments.
//   ulp                      prints the table of docs/numerics.md
//   ulp --check              fails when a formula exceeds its bound (bounds.h)
//   ulp --write PAGE         puts the table into the page
#include <fmt/format.h>

#include <string_view>

#include "bounds.h"
#include "measure.h"
#include "tests/page.h"

namespace welkin::numerics {
namespace {

constexpr std::size_t kEvaluations = std::size_t{1} << 18;

std::string tableOf(const std::vector<Measured>& formulas) {
  std::string text =
      "| formula | float, ulp | bound | where | GPU, ulp | bound | where | GPU against float "
      "|\n|---|---|---|---|---|---|---|---|\n";
  for (const Measured& m : formulas)
    for (const Bound& bound : bounds())
      if (bound.formula == m.formula)
        text += fmt::format("| {} | {:.2f} | {:g} | {} | {:.2f} | {:g} | {} | {:.2f} |\n", m.formula, m.floats.ulp,
                            bound.floats, m.floats.where, m.gpu.ulp, bound.gpu, m.gpu.where, m.apart);
  return text;
}

int check(const std::vector<Measured>& formulas) {
  int status = 0;
  const auto complain = [&](const std::string& what) {
    fmt::print(stderr, "{}\n", what);
    status = 1;
  };
  for (const Measured& m : formulas) {
    const Bound* bound = nullptr;
    for (const Bound& b : bounds())
      if (b.formula == m.formula) bound = &b;
    if (bound == nullptr) {
      complain(
          fmt::format("{} has no bound: {:.2f} ulp as floats, {:.2f} on the GPU", m.formula, m.floats.ulp, m.gpu.ulp));
      continue;
    }
    if (m.floats.ulp > bound->floats)
      complain(fmt::format("{}: {} ulp as floats, more than {}: {}", m.formula, m.floats.ulp, bound->floats,
                           m.floats.where));
    if (m.gpu.ulp > bound->gpu)
      complain(fmt::format("{}: {} ulp on the GPU, more than {}: {}", m.formula, m.gpu.ulp, bound->gpu, m.gpu.where));
  }
  return status;
}

}  // namespace
}  // namespace welkin::numerics

int main(int count, char** arguments) {
  using namespace welkin::numerics;
  const std::string_view option = count > 1 ? arguments[1] : "";
  std::string device;
  const auto formulas = measure(kEvaluations, true, device);
  if (option == "--check") return check(formulas);
  const std::string text = fmt::format("{} evaluations; GPU: {}.\n\n{}", kEvaluations, device, tableOf(formulas));
  if (option == "--write" && count == 3) return welkin::tests::bringUpToDate(arguments[2], "numerics", text, true);
  fmt::print("{}", text);
  return 0;
}
