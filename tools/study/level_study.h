// SPDX-License-Identifier: Apache-2.0
// A study of a level: bytes against the error on surfaces and in the air, for every way to bake its probes.
#pragma once

#include "probes/build/subject.h"
#include "sky/base/progress.h"
#include "study/report.h"

namespace welkin::study {

struct LevelStudyOptions {
  bool quick = false;  ///< fewer ways, points and hours
  base::Progress progress = {};
};

/// Ways that a study bakes, each a step of its progress.
std::size_t levelWays(bool quick);

/// Bakes every sector of a level by every way, in memory, and measures the error at one set of points. The subject has
/// a level. Everything but times is the same for any number of threads. Throws Error(content) for a level without
/// sectors, and what LevelBake throws.
StudyReport studyLevel(const build::Subject& subject, const LevelStudyOptions& options);

}  // namespace welkin::study
