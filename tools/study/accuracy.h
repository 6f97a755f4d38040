// SPDX-License-Identifier: Apache-2.0
// The page docs/accuracy.md: the study condensed over every named luminance model, and of one example.
#pragma once

#include <string>

#include "study/study.h"

namespace welkin::study {

/// A luminance model under a sun from -18 degrees to the zenith and back.
struct ModelRow {
  std::string model;
  bool grey = false;
  double bands[3] = {};         ///< error at exact keys of 2, 3, 5 bands
  double fitted_bands[3] = {};  ///< the same, fitted
  double modes[4] = {};         ///< error with 4, 5, 6, 8 modes, fitted, in the largest map
  std::size_t bytes[4] = {};    ///< the least table's for kBudgets; 0: cannot be met
  std::size_t keys[4] = {};
};

/// Measures every named model, in the example's colours and grey, every `step_h` of a day whose sun climbs to the
/// zenith. Only the gradients are the example's.
std::vector<ModelRow> measureModels(const model::Sky& example, double step_h, const StudyOptions& options);

/// The sky of a row: intensity 1 all day, no ground, no desaturation.
model::Sky modelSky(const model::LuminanceModel& model, const model::Sky& example, bool grey);

/// The table of all approximations of Welkin: domain, largest error, cost, slow reference and test. "Here" is the
/// study's sky.
std::string approximationsTable(const Study& study);

/// Markdown; the same for the same measurements.
std::string accuracyPage(const std::vector<ModelRow>& models, const Study& example, double step_h,
                         const std::string& command);

}  // namespace welkin::study
