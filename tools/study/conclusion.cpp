// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "study/study.h"

namespace welkin::study {
namespace {

std::string bytes(double value) {
  return inWords(value, Quantity::bytes, 3);
}

/// The candidate of a name, or null.
const Candidate* find(const std::vector<Candidate>& candidates, const std::string& name) {
  const auto at = std::find_if(candidates.begin(), candidates.end(),
                               [&](const Candidate& candidate) { return candidate.name == name; });
  return at == candidates.end() ? nullptr : &*at;
}

/// The candidate of `count` modes with the least error, or null.
const Candidate* bestModes(const std::vector<Candidate>& candidates, std::size_t count) {
  const Candidate* best = nullptr;
  for (const Candidate& candidate : candidates)
    if (candidate.isModes() && candidate.numbers() == count && (best == nullptr || candidate.error < best->error))
      best = &candidate;
  return best;
}

std::string budgetSentence(const BudgetRow& row, const bake::Target& target) {
  if (!row.plan.met)
    return fmt::format("Nothing that {} keeps the irradiance within {}: the best is {}, by {}.",
                       target.sh_bands == 0 ? "a file can hold" : fmt::format("target \"{}\" reads", target.name),
                       share(row.max_error), share(row.plan.predicted_error), row.plan.representation.name());
  const auto& modes = row.plan.representation.modes;
  return fmt::format("Within {} the least is {}: {} with {} keys of {}, at {}{}.", share(row.max_error),
                     bytes(static_cast<double>(row.plan.bytes)), row.plan.representation.name(),
                     row.plan.table.key_time_h.size(), nameOf(row.plan.encoding), share(row.plan.predicted_error),
                     modes && modes->count > 8 ? "; the shader includes do not read so many modes" : "");
}

/// ", " before an item of a list, ", and " before the last, and nothing before the first.
const char* jointOf(std::size_t item, std::size_t count) {
  return item == 0 ? "" : item + 1 == count ? ", and" : ",";
}

/// Pairs of candidates that differ in the way to find their numbers alone, projected first, by rising bands.
using Pair = std::pair<const Candidate*, const Candidate*>;
std::vector<Pair> pairsWith(const std::vector<Candidate>& candidates, const char* fit) {
  std::vector<Pair> pairs;
  for (const int bands : {2, 3, 5}) {
    const Candidate* projected = find(candidates, fmt::format("{} bands", bands));
    const Candidate* other = find(candidates, fmt::format("{} bands, {}", bands, fit));
    if (projected != nullptr && other != nullptr) pairs.emplace_back(projected, other);
  }
  return pairs;
}

std::string bandsParagraph(const std::vector<Candidate>& candidates) {
  std::string text = "At exact keys";
  const auto pairs = pairsWith(candidates, "fitted");
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [projected, fitted] = pairs[i];
    text += fmt::format("{} {} bands {} {} projected and {} fitted", jointOf(i, pairs.size()),
                        projected->representation.bands, i == 0 ? "err by up to" : "by", share(projected->error),
                        share(fitted->error));
  }
  return text + ".";
}

std::string windowParagraph(const std::vector<Candidate>& candidates) {
  std::string text = "The mildest window that keeps irradiance from being negative";
  bool wins = false;
  bool taken = false;
  const auto pairs = pairsWith(candidates, "mildest window");
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [projected, windowed] = pairs[i];
    const int bands = projected->representation.bands;
    wins = wins || windowed->error < projected->error;
    const char* joint = jointOf(i, pairs.size());
    text += windowed->window_strength > 0.0
                ? fmt::format("{}{} {} bands from {} to {}", joint, taken ? "" : " takes", bands,
                              share(projected->error), share(windowed->error))
                : fmt::format("{} leaves {} bands alone, which are never negative", joint, bands);
    taken = taken || windowed->window_strength > 0.0;
  }
  return text + (wins ? ". For some it lessens the error, so it is worth trying for this sky."
                      : ". It lessens no error, so windows stay off unless negative light cannot be borne.");
}

std::string modesParagraph(const std::vector<Candidate>& candidates, const bake::Target& target) {
  if (target.sh_bands > 0)
    return fmt::format("Target \"{}\" reads no more than {} bands, and no modes, which hold less error.", target.name,
                       target.sh_bands);
  std::size_t first = 0;
  for (std::size_t count = 1; count <= table::DayModes::kMost && first == 0; ++count) {
    const Candidate* candidate = bestModes(candidates, count);
    if (candidate != nullptr && candidate->error < 0.01) first = count;
  }
  std::string text = first > 0 ? fmt::format("The fewest modes that keep 1 % are {}", first)
                               : std::string("No number of modes that was looked at keeps 1 %");
  for (const std::size_t count : {4, 8})
    if (const Candidate* candidate = bestModes(candidates, count))
      text += fmt::format("; {} reach {} (map {} x {}{})", count, share(candidate->error),
                          candidate->representation.modes->columns, candidate->representation.modes->rows,
                          candidate->fit == Fit::fitted ? ", fitted" : "");
  text += ".";
  const Candidate* eight = bestModes(candidates, 8);
  const Candidate* twelve = bestModes(candidates, table::DayModes::kMost);
  if (eight != nullptr && twelve != nullptr)
    text +=
        fmt::format(" Four more modes, which the shader includes do not read, would bring {}.", share(twelve->error));
  return text;
}

std::string shadersParagraph(const std::vector<NamedShaderCost>& shaders) {
  std::string text = "These are the costs of a pixel's irradiance.";
  for (const auto& [name, cost] : shaders) {
    if (!name.starts_with("irradiance ")) continue;
    text +=
        fmt::format(" With {}: {} scalar operations, {} {}, {} uniform loads.", name.substr(11), cost.scalar_operations,
                    cost.texture_fetches, cost.texture_fetches == 1 ? "fetch" : "fetches", cost.uniform_loads);
  }
  return text + " These are static instructions of the optimised SPIR-V with its loops unrolled.";
}

std::string cubicParagraph(const KeyStudy& keys) {
  std::size_t better = 0;
  std::size_t worse = 0;
  for (const KeyCounts& row : keys.counts) ++(row.catmull_rom < 0.95 * row.max_error ? better : worse);
  std::string text = fmt::format(
      "Cubic interpolation through the keys that linear interpolation takes does no better than the aim in {} of {} "
      "cases.",
      worse, better + worse);
  if (keys.counts.empty()) return text;
  double most_numbers = 0.0;
  double least_numbers = 1e30;
  for (const KeyCounts& row : keys.counts) {
    const double ratio = static_cast<double>(row.placed) / static_cast<double>(row.hermite);
    most_numbers = std::max(most_numbers, ratio);
    least_numbers = std::min(least_numbers, ratio);
  }
  text += fmt::format(
      " The most favourable cubic has slopes of its own on both sides of every key. It takes {:.2g} to {:.2g} times "
      "fewer keys at three times the numbers",
      least_numbers, most_numbers);
  text += most_numbers > 3.0
              ? ": for some aims that pays."
              : ": it does not pay. Days bend at the columns of the gradients, at sunrise and at sunset, "
                "and a cubic does not follow a bend.";
  double ratio = 1.0;
  for (const KeyCounts& row : keys.counts)
    for (const EvenKeys& even : keys.even)
      if (even.representation == row.representation && even.linear <= row.max_error) {
        ratio = std::max(ratio, static_cast<double>(even.keys) / static_cast<double>(row.placed));
        break;
      }
  return text + fmt::format(" The placement of keys matters more: even keys take up to {:.2g} times as many.", ratio);
}

std::string encodingsParagraph(const std::vector<EncodingRow>& rows) {
  std::string text = "Rounding the numbers adds at most";
  bool first = true;
  for (const auto encoding : format::kEncodings) {
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
  std::string text = "The quadrature keeps its tolerances.";
  for (const QuadratureRow& row : study.quadrature) {
    if (&row == &study.quadrature.back()) break;
    text += fmt::format(" Under {:.0e} the error is {:.1e}, for {:.0f} evaluations a key.", row.tolerance, row.error,
                        row.evaluations);
  }
  if (!study.irradiance.empty())
    text += fmt::format(" Circles (IrradianceProjector) give every normal at once within {} of direct integration.",
                        share(study.irradiance.front().error));
  return text;
}

}  // namespace

std::vector<std::string> conclusionOf(const Study& study, const bake::Target& target) {
  std::string budgets;
  for (const BudgetRow& row : study.tables.budgets) {
    if (!budgets.empty()) budgets += ' ';
    budgets += budgetSentence(row, target);
  }
  return {
      budgets,
      bandsParagraph(study.candidates) + " " + modesParagraph(study.candidates, target),
      windowParagraph(study.candidates),
      shadersParagraph(study.shaders),
      cubicParagraph(study.keys),
      encodingsParagraph(study.tables.encodings),
      cubemapsParagraph(study.cubemaps),
      quadratureParagraph(study.quadrature),
      "Errors are the largest over normals, channels and instants, by the measure of docs/conventions.md. Times are of "
      "the machine that made this study; everything else is the same on every machine."};
}

}  // namespace welkin::study
