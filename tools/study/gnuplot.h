// SPDX-License-Identifier: Apache-2.0
// Runs gnuplot, which draws the charts of a study.
#pragma once

#include <optional>
#include <string>

namespace welkin::study {

/// The output of a script: a picture, when it sets a terminal and plots. Runs `gnuplot -d` from PATH
/// without a shell and without the user's settings; none when there is no gnuplot. Throws Error(file) with the first
/// line that gnuplot says when it fails, or when the disk for temporary files is full.
std::optional<std::string> runGnuplot(const std::string& script);

}  // namespace welkin::study
