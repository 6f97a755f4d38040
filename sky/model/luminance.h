// SPDX-License-Identifier: Apache-2.0
// The named luminance models and the test that free coefficients must pass.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sky/model/light.h"

namespace welkin::model {

using det::LuminanceModel;

struct NamedLuminance {
  std::string_view name;
  LuminanceModel model;
};

/// "cie-1" .. "cie-15" (CIE S 011/E:2003, table 1), "cie-overcast" (Moon and Spencer 1942), "far-cry-3" (McAuley 2012,
/// table 1 with the sign of c corrected).
const std::vector<NamedLuminance>& namedLuminances();

/// Returns the model of that name, or null if there is none.
const LuminanceModel* findLuminance(std::string_view name);

/// Returns the reason why a model cannot be used under the given sun, if there is one. The reason is a coefficient out
/// of its domain, or a luminance below 1e-9 or negative in some direction during the day. The text names coefficient,
/// sun elevation and direction. The scan takes every minute of the day and every key. It covers the angle to the sun by
/// 1/8 of a degree and refines by golden section.
std::optional<std::string> whyUnusable(const LuminanceModel& model, const LightPath& sun);

}  // namespace welkin::model
