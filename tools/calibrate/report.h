// SPDX-License-Identifier: Apache-2.0
// A calibration as JSON.
#pragma once

#include <nlohmann/json.hpp>

#include "calibrate/photo.h"

namespace welkin::calibrate {

/// A chart that had no part in the fit: its place and CIEDE2000 before and after the model.
nlohmann::ordered_json chartErrorJson(const ChartError& error);

/// Charts, model, sum of squares and CIEDE2000: what `welkin calibrate --json` prints of a photograph.
nlohmann::ordered_json summaryJson(const CalibratedPhoto& photo);

/// The summary, and each patch, each model that was tried and all warnings: report.json.
nlohmann::ordered_json reportJson(const CalibratedPhoto& photo, const ReferenceChart& reference);

}  // namespace welkin::calibrate
