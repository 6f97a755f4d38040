// SPDX-License-Identifier: Apache-2.0
#include "calibrate/left_out.h"

#include "calibrate/colour_difference.h"

namespace welkin::calibrate {
namespace {

double difference(const Colour& rgb, const Colour& wanted) {
  return ciede2000(labOfRgb(rgb), labOfRgb(wanted));
}

}  // namespace

std::vector<double> differencesBefore(std::span<const Pair> pairs) {
  std::vector<double> result;
  for (const Pair& p : pairs) result.push_back(difference(p.measured, p.wanted));
  return result;
}

std::vector<double> differences(std::span<const Pair> pairs, const Model& model) {
  std::vector<double> result;
  for (const Pair& p : pairs) result.push_back(difference(model(p.measured), p.wanted));
  return result;
}

std::optional<std::vector<double>> differencesLeftOut(std::span<const Pair> pairs, std::span<const std::size_t> group,
                                                      const ModelKind& kind) {
  std::vector<double> result(pairs.size(), 0.0);
  std::vector<bool> done(pairs.size(), false);
  for (std::size_t first = 0; first < pairs.size(); ++first) {
    if (done[first]) continue;
    std::vector<Pair> others;
    for (std::size_t i = 0; i < pairs.size(); ++i)
      if (group[i] != group[first]) others.push_back(pairs[i]);
    auto numbers = kind.fit(others);
    if (!numbers) return std::nullopt;
    const Model model{&kind, std::move(*numbers)};
    for (std::size_t i = first; i < pairs.size(); ++i)
      if (group[i] == group[first]) {
        result[i] = difference(model(pairs[i].measured), pairs[i].wanted);
        done[i] = true;
      }
  }
  return result;
}

}  // namespace welkin::calibrate
