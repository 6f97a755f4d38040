// SPDX-License-Identifier: Apache-2.0
// A whole study of a sky: cost and error of every representation that a bake can choose.
#pragma once

#include "sky/bake/sky_file.h"
#include "study/measure_cubemaps.h"
#include "study/measure_keys.h"
#include "study/measure_quadrature.h"
#include "study/measure_tables.h"

namespace welkin::study {

/// Everything that was measured.
struct Study {
  std::vector<Candidate> candidates;
  std::vector<NamedShaderCost> shaders;
  KeyStudy keys;
  TableStudy tables;
  CubemapStudy cubemaps;
  QuadratureStudy quadrature;
};

/// Measures every axis. Everything but times is the same for any number of threads. Throws Error(interrupted) when a
/// progress says so.
Study measureSky(const StudyDay& day, const StudyOptions& options);

/// Axes of a study: how often `progress` is told.
inline constexpr std::size_t kAxes = 8;

/// Samples the day, measures what the file's target can read, and reports; nothing is written. Throws as measureSky.
StudyReport studySky(const bake::SkyFile& file, StudyOptions options);

/// The conclusions in words: paragraphs of a sentence or a few.
std::vector<std::string> conclusionOf(const Study& study, const bake::Target& target = bake::kTargets[0]);

}  // namespace welkin::study
