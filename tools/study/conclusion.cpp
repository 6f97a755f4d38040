// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/study.h"

namespace welkin::study {
namespace {

std::string share(double value) {
  return inWords(value, Quantity::share, 2);
}
std::string bytes(double value) {
  return inWords(value, Quantity::bytes, 3);
}

/// The way of a name, or null.
const Way* find(const std::vector<Way>& ways, const std::string& name) {
  const auto at = std::find_if(ways.begin(), ways.end(), [&](const Way& way) { return way.name == name; });
  return at == ways.end() ? nullptr : &*at;
}

/// Of `count` modes the way with the least error, or null.
const Way* bestModes(const std::vector<Way>& ways, std::size_t count) {
  const Way* best = nullptr;
  for (const Way& way : ways)
    if (way.isModes() && way.numbers() == count && (best == nullptr || way.error < best->error)) best = &way;
  return best;
}

std::string budgetSentence(const BudgetRow& row) {
  if (!row.plan.met)
    return fmt::format("Nothing that a file can hold keeps the irradiance within {}: the best is {}, by {}.",
                       share(row.max_error), share(row.plan.predicted_error), row.plan.representation.name());
  const auto& modes = row.plan.representation.modes;
  return fmt::format("Within {} the least is {}: {} with {} keys of {}, at {}{}.", share(row.max_error),
                     bytes(static_cast<double>(row.plan.bytes)), row.plan.representation.name(),
                     row.plan.table.key_time_h.size(), nameOf(row.plan.encoding), share(row.plan.predicted_error),
                     modes && modes->count > 8 ? "; more modes than the shader includes read" : "");
}

std::string bandsParagraph(const std::vector<Way>& ways) {
  std::string text = "At exact keys";
  for (const int bands : {2, 3, 5}) {
    const Way* projected = find(ways, fmt::format("{} bands", bands));
    const Way* fitted = find(ways, fmt::format("{} bands, fitted", bands));
    if (projected == nullptr || fitted == nullptr) continue;
    text += fmt::format("{} {} bands err by up to {} projected and {} fitted",
                        bands == 2   ? ""
                        : bands == 5 ? ", and"
                                     : ",",
                        bands, share(projected->error), share(fitted->error));
  }
  return text + ".";
}

std::string windowParagraph(const std::vector<Way>& ways) {
  std::string text = "The mildest window that keeps irradiance from being negative";
  bool wins = false;
  bool taken = false;
  for (const int bands : {2, 3, 5}) {
    const Way* projected = find(ways, fmt::format("{} bands", bands));
    const Way* windowed = find(ways, fmt::format("{} bands, mildest window", bands));
    if (projected == nullptr || windowed == nullptr) continue;
    wins = wins || windowed->error < projected->error;
    const char* joint = bands == 2 ? "" : bands == 5 ? ", and" : ",";
    text += windowed->window_strength > 0.0
                ? fmt::format("{}{} {} bands from {} to {}", joint, taken ? "" : " takes", bands,
                              share(projected->error), share(windowed->error))
                : fmt::format("{} leaves {} bands alone, which are never negative", joint, bands);
    taken = taken || windowed->window_strength > 0.0;
  }
  return text + (wins ? ": for some it lessens the error, so it is worth trying for this sky."
                      : ": it lessens no error, so windows stay off unless negative light cannot be borne.");
}

std::string modesParagraph(const std::vector<Way>& ways) {
  std::size_t first = 0;
  for (std::size_t count = 1; count <= table::DayModes::kMost && first == 0; ++count) {
    const Way* way = bestModes(ways, count);
    if (way != nullptr && way->error < 0.01) first = count;
  }
  std::string text = first > 0 ? fmt::format("{} modes are the fewest that keep 1 %", first)
                               : std::string("No number of modes that was looked at keeps 1 %");
  for (const std::size_t count : {4, 8})
    if (const Way* way = bestModes(ways, count))
      text += fmt::format("; {} reach {} (map {} x {}{})", count, share(way->error), way->representation.modes->columns,
                          way->representation.modes->rows, way->fit == Fit::fitted ? ", fitted" : "");
  text += ".";
  const Way* eight = bestModes(ways, 8);
  const Way* twelve = bestModes(ways, table::DayModes::kMost);
  if (eight != nullptr && twelve != nullptr)
    text +=
        fmt::format(" The limit of 8 is {}: four more modes, which the shader includes do not read, would bring {}.",
                    share(eight->error), share(twelve->error));
  return text;
}

std::string shadersParagraph(const std::vector<NamedShaderCost>& shaders) {
  std::string text = "A pixel's irradiance takes";
  bool first = true;
  for (const auto& [name, cost] : shaders) {
    if (!name.starts_with("irradiance ")) continue;
    text += fmt::format("{} {} scalar operations, {} {} and {} uniform loads with {}", first ? "" : ",",
                        cost.scalar_operations, cost.texture_fetches, cost.texture_fetches == 1 ? "fetch" : "fetches",
                        cost.uniform_loads, name.substr(11));
    first = false;
  }
  return text + ".";
}

std::string cubicParagraph(const KeyStudy& keys) {
  std::size_t better = 0;
  std::size_t worse = 0;
  for (const KeyCounts& row : keys.counts) ++(row.catmull_rom < 0.95 * row.max_error ? better : worse);
  std::string text = fmt::format(
      "Cubic interpolation through the keys that are placed for linear does no better than the aim in {} of {} cases",
      worse, better + worse);
  double most_numbers = 0.0;
  double least_numbers = 1e30;
  for (const KeyCounts& row : keys.counts) {
    const double ratio = static_cast<double>(row.placed) / static_cast<double>(row.hermite);
    most_numbers = std::max(most_numbers, ratio);
    least_numbers = std::min(least_numbers, ratio);
  }
  if (!keys.counts.empty())
    text += fmt::format(
        "; the most favourable cubic, with slopes of its own on both sides of every key, takes {:.2g} to {:.2g} times "
        "fewer "
        "keys at three times the numbers",
        least_numbers, most_numbers);
  text += most_numbers > 3.0
              ? ": for some aims that pays."
              : ": it does not pay. Days bend at the columns of the gradients, at sunrise and at sunset, "
                "and a cubic does not follow a bend.";
  double ratio = 1.0;
  for (const KeyCounts& row : keys.counts)
    for (const EvenKeys& even : keys.even)
      if (even.way == row.way && even.linear <= row.max_error) {
        ratio = std::max(ratio, static_cast<double>(even.keys) / static_cast<double>(row.placed));
        break;
      }
  return text + fmt::format(" Where keys sit matters more: even ones take up to {:.2g} times as many.", ratio);
}

std::string encodingsParagraph(const std::vector<EncodingRow>& rows) {
  std::string text = "Rounding the numbers adds at most";
  bool first = true;
  for (const auto encoding :
       {table::Encoding::float32, table::Encoding::float16, table::Encoding::fixed16, table::Encoding::fixed8}) {
    double most = 0.0;
    for (const EncodingRow& row : rows)
      if (row.encoding == encoding) most = std::max(most, row.encoding_error);
    text += fmt::format("{} {} as {}", first ? "" : ",", share(most), nameOf(encoding));
    first = false;
  }
  return text + ".";
}

std::string cubemapsParagraph(const CubemapStudy& study) {
  std::string text;
  for (const CubemapBudgetRow& row : study.budgets)
    text += row.plan.met ? fmt::format("Cubemaps within {} take {}: {} of {} in {}, measured {}. ",
                                       share(row.max_error), bytes(row.plan.bytes), row.plan.time_h.size(),
                                       row.plan.size, format::nameOf(row.plan.format), share(row.plan.measured.error))
                         : fmt::format("Cubemaps within {} cannot be had: {}. ", share(row.max_error), row.plan.reason);
  for (const DomeRow& row : study.dome)
    if (row.format == model::GradientFormat::rgb9e5)
      text += fmt::format("The analytic dome takes no cubemaps and errs by {} with gradients in rgb9e5, {}.",
                          share(row.error), bytes(row.bytes));
  return text;
}

std::string quadratureParagraph(const QuadratureStudy& study) {
  std::string text = "The quadrature keeps its promise when";
  bool first = true;
  for (const QuadratureRow& row : study.quadrature) {
    if (&row == &study.quadrature.back()) break;
    text += fmt::format("{} {:.0e} stays within {:.1e} by {:.0f} evaluations a key", first ? "" : ",", row.tolerance,
                        row.error, row.evaluations);
    first = false;
  }
  text += ".";
  if (!study.irradiance.empty())
    text += fmt::format(" Circles (IrradianceProjector) give every normal at once within {} of direct integration.",
                        share(study.irradiance.front().error));
  return text;
}

}  // namespace

std::vector<std::string> conclusionOf(const Study& study) {
  std::string budgets;
  for (const BudgetRow& row : study.tables.budgets) {
    if (!budgets.empty()) budgets += ' ';
    budgets += budgetSentence(row);
  }
  return {
      budgets,
      bandsParagraph(study.ways) + " " + modesParagraph(study.ways),
      windowParagraph(study.ways),
      shadersParagraph(study.shaders),
      cubicParagraph(study.keys),
      encodingsParagraph(study.tables.encodings),
      cubemapsParagraph(study.cubemaps),
      quadratureParagraph(study.quadrature),
      "Errors are the largest over normals, channels and instants, by the measure of docs/conventions.md; times are of "
      "the machine that made this study, everything else is the same on every one."};
}

}  // namespace welkin::study
