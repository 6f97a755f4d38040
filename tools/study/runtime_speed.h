// SPDX-License-Identifier: Apache-2.0
// Time that a game's processor takes to read a baked sky.
#pragma once

#include "sky/bake/sky_file.h"
#include "study/study_day.h"

namespace welkin::study {

/// Nanoseconds of one call, the least of a few rounds of some thousand calls over the day, on one thread.
struct RuntimeSpeed {
  double sample_ns = 0.0;      ///< welkin_sky_sample
  double irradiance_ns = 0.0;  ///< welkin_sky_irradiance, a normal
  std::size_t file_bytes = 0;  ///< the whole file's, without cubemaps
};

/// Measures a file that holds `candidate` at `keys` even instants as float32.
RuntimeSpeed measureRuntime(const bake::SkyFile& file, const StudyDay& day, const Candidate& candidate,
                            std::size_t keys);

/// Indices of the instants nearest to `count` even hours, each once, ascending.
std::vector<std::size_t> evenKeys(const StudyDay& day, std::size_t count);

}  // namespace welkin::study
