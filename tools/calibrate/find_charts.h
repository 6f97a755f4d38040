// SPDX-License-Identifier: Apache-2.0
// Looks for charts in a picture of linear light.
#pragma once

#include <functional>
#include <vector>

#include "calibrate/chart_module.h"
#include "sky/image/image.h"

namespace welkin::calibrate {

/// What may be charts, from OpenCV's detector on encoded pictures of several sizes and exposures. False ones are among
/// them, and judge.h tells them from charts. So the search ends with the first picture whose candidates are `enough`;
/// if none are, it returns those of the first that has any. Without `enough`, any are. The same for any number of
/// threads.
std::vector<Candidate> findCandidates(const image::Image& image,
                                      const std::function<bool(const std::vector<Candidate>&)>& enough = {});

}  // namespace welkin::calibrate
