// SPDX-License-Identifier: Apache-2.0
// Measures the shading formulas of docs/materials.md: factors, what a white furnace gets back, highlights of bumps.
//   material_table                prints the tables
//   material_table --write PAGE   puts them into the page
#include <fmt/format.h>

#include <string_view>

#include "highlight.h"
#include "tests/materials/furnace.h"
#include "tests/page.h"

namespace welkin::tests {
namespace {

std::string factors() {
  std::string text =
      "| gloss | power | E | E'/E | (2m + 1)/8 | (m + 2)/8 | (4m - 1)/8 | (8m - 5)/8 "
      "|\n|---|---|---|---|---|---|---|---|\n";
  for (int i = 0; i <= 10; ++i) {
    const double g = i / 10.0, m = f64::powerOfGloss(g), mean = f64::meanFactor(g);
    text +=
        fmt::format("| {:.1f} | {:.1f} | {:.4g} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", g, m, mean,
                    f64::fittedFactor(g) / mean, f64::shippedFactor(m) / mean, f64::linearFactor(m, 1.0, 2.0) / mean,
                    f64::linearFactor(m, 4.0, -1.0) / mean, f64::linearFactor(m, 8.0, -5.0) / mean);
  }
  return text;
}

std::string furnaces() {
  using f64::Number3;
  std::string text = "| power | form | 0 | 30 | 60 | 75 | 85 degrees |\n|---|---|---|---|---|---|---|\n";
  constexpr int kSteps = 1500;
  for (const double m : {1.0, 8.0, 64.0, 1024.0, 8192.0}) {
    std::string full = fmt::format("| {} | Schlick-Smith |", m), shipped = fmt::format("| {} | shipped |", m);
    for (const double degrees : {0.0, 30.0, 60.0, 75.0, 85.0}) {
      full += fmt::format(" {:.3f} |", furnace(m, degrees * f64::kDegree, kSteps,
                                               [&](const Number3& l, const Number3& v, const Number3& h) {
                                                 return f64::schlickSmithLobe(m, l.y, v.y, h.y);
                                               }));
      shipped += fmt::format(" {:.3f} |", furnace(m, degrees * f64::kDegree, kSteps,
                                                  [&](const Number3& l, const Number3& v, const Number3& h) {
                                                    return f64::factoredLobe(f64::shippedFactor(m), m, l.y, v.y, h.y);
                                                  }));
    }
    text += full + "\n" + shipped + "\n";
  }
  return text;
}

std::string highlights() {
  std::string text =
      "| bumps | texels in a pixel | none: error | energy | average: error | energy | full: error | energy |\n"
      "|---|---|---|---|---|---|---|---|\n";
  constexpr double kPower = 512.0;
  for (const double deviation : {0.02, 0.05, 0.1, 0.2}) {
    const gloss::NormalMap map = gaussianBumps(128, deviation);
    gloss::GlossMap number;
    number.number = f64::glossOfPower(kPower);
    const auto mips = gloss::mipsOf(map, number);
    const double average = f64::powerOfGloss(gloss::averageFactorOf(mips).gloss);
    for (const auto& [k, side] : {std::pair<std::size_t, int>(0, 1), {2, 4}, {4, 16}}) {
      const gloss::Mip& mip = mips[k];
      const Highlight none = highlightOf(map, kPower, mip, side, [&](std::size_t) { return kPower; });
      const Highlight one = highlightOf(map, kPower, mip, side, [&](std::size_t) { return average; });
      const Highlight full =
          highlightOf(map, kPower, mip, side, [&](std::size_t i) { return f64::powerOfGloss(double{mip.gloss[i]}); });
      text += fmt::format("| {} | {} x {} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} |\n", deviation, side,
                          side, none.error, none.energy, one.error, one.energy, full.error, full.energy);
    }
  }
  return text;
}

}  // namespace
}  // namespace welkin::tests

int main(int count, char** arguments) {
  using namespace welkin::tests;
  if (count == 3 && std::string_view(arguments[1]) == "--write") {
    bringUpToDate(arguments[2], "factors", factors(), true);
    bringUpToDate(arguments[2], "furnaces", furnaces(), true);
    return bringUpToDate(arguments[2], "highlights", highlights(), true);
  }
  fmt::print("{}\n{}\n{}", factors(), furnaces(), highlights());
  return 0;
}
