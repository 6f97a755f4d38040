// SPDX-License-Identifier: Apache-2.0
#include "study/study_day.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "format/day_numbers.h"
#include "sh/window.h"

namespace welkin::study {
namespace {

constexpr int kBandsBesideModes = 3;  // a sample's, as in sky/table/plan.cpp

/// Lessens the bands of every instant by one window for the day.
double applyMildestWindow(const StudyDay& day, table::Representation& r) {
  std::vector<det::Number3> normals;  // on one side of the sun's plane, the frame's pole as the basis' own
  for (std::size_t p = 0; p < day.grid().count(); ++p) {
    const det::Number3 n = day.grid().normal(p).inSunFrame();
    normals.emplace_back(n.z, n.x, n.y);
  }
  const auto count = static_cast<std::size_t>(r.bands * r.bands);
  std::vector<double> sets;
  for (std::size_t i = 0; i < day.count(); ++i)
    for (int c = 0; c < 3; ++c) {
      std::vector<double> set(count);
      for (int l = 0; l < r.bands; ++l)
        for (int m = 0; m <= l; ++m)
          set[static_cast<std::size_t>(sh::indexOf(l, m))] = r.weight[i * r.rows + model::polarIndex(l, m)][c];
      sets.insert(sets.end(), set.begin(), set.end());
    }
  const sh::Window window = sh::mildestWindow(sets, r.bands, normals);
  for (std::size_t i = 0; i < day.count(); ++i)
    for (int l = 0; l < r.bands; ++l)
      for (int m = 0; m <= l; ++m)
        r.weight[i * r.rows + model::polarIndex(l, m)] =
            r.weight[i * r.rows + model::polarIndex(l, m)] * window.factor[static_cast<std::size_t>(l)];
  return window.strength;
}

}  // namespace

StudyDay::StudyDay(const model::Sky& sky, double step_h, const base::Progress& progress)
    : fields_(table::sampleDay(sky, table::hoursOfInterest(sky, step_h), table::brightestOf(sky), progress)),
      values_(fields_, grid_) {}

std::size_t Candidate::numbers() const {
  const bool has_band_3 = !isModes() && representation.bands > 3;  // which no irradiance has
  return representation.functions - (has_band_3 ? 4 : 0);
}

std::size_t Candidate::bytesOfKey(const model::Sky& sky, table::Encoding encoding) const {
  return format::bytesOfKey(encoding, representation.rows * (table::isGrey(sky) ? 1 : 3));
}

std::size_t Candidate::bytes(const model::Sky& sky, std::size_t keys, table::Encoding encoding) const {
  const std::size_t numbers_of_key = representation.rows * (table::isGrey(sky) ? 1 : 3);
  return representation.fixedBytes() + format::bytesOfTable(encoding, keys, numbers_of_key);
}

Candidate bandsCandidate(const StudyDay& day, int bands, Fit fit) {
  Candidate candidate{fmt::format("{} bands", bands), table::coefficientsOf(day.values(), bands, fit == Fit::fitted),
                      fit};
  if (fit == Fit::fitted) candidate.name += ", fitted";
  if (fit == Fit::windowed) {
    candidate.name += ", mildest window";
    candidate.window_strength = applyMildestWindow(day, candidate.representation);
  }
  candidate.error = errorAtKeys(day, candidate.representation);
  return candidate;
}

DayWeights modeWeights(const StudyDay& day, const table::DayModes& modes, std::size_t count) {
  DayWeights result{modes.best(count), {}};
  result.weights = table::weightsOf(day.values(), result.set);
  return result;
}

Candidate modesCandidate(const StudyDay& day, const DayWeights& modes, MapSize map, Fit fit) {
  Candidate candidate{fmt::format("{} modes, map {} x {}", modes.set.count(), map.columns, map.rows),
                      table::modesOf(day.values(), modes.set, modes.weights, map.columns, map.rows, kBandsBesideModes),
                      fit};
  if (fit == Fit::fitted) {
    table::fitWeights(day.values(), candidate.representation);
    candidate.name += ", fitted";
  }
  candidate.error = errorAtKeys(day, candidate.representation);
  return candidate;
}

double errorAtKeys(const StudyDay& day, const table::Representation& r) {
  std::vector<double> error(day.count());
  tbb::parallel_for(std::size_t{0}, error.size(), [&](std::size_t i) {
    error[i] = table::errorOf(day.values(), r, i, {r.weight.data() + i * r.rows, r.rows}).value;
  });
  return *std::max_element(error.begin(), error.end());
}

}  // namespace welkin::study
