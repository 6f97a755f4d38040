// SPDX-License-Identifier: Apache-2.0
// Looks for charts in a picture of linear light.
#pragma once

#include <vector>

#include "calibrate/chart_module.h"
#include "sky/image/image.h"

namespace welkin::calibrate {

/// What may be charts, from OpenCV's detector on encoded pictures of several sizes and exposures; the first of these
/// that gives any serves. False ones are among them: judge.h tells them from charts. The same for any number of
/// threads.
std::vector<Candidate> findCandidates(const image::Image& image);

}  // namespace welkin::calibrate
