// SPDX-License-Identifier: Apache-2.0
// The first axis of a study: bands and their reconstruction, modes and their maps. Error at exact keys against the
// cost of a key, a sample and a pixel.
#pragma once

#include <optional>

#include "study/report.h"
#include "study/runtime_speed.h"
#include "study/shader_cost.h"

namespace welkin::study {

/// The candidates of a study, in the order of its tables: bands, then modes, as far as the target reads them. A quick
/// one has a few.
std::vector<Candidate> collectCandidates(const StudyDay& day, const StudyOptions& options);

/// Cost of the shader that reads a candidate; none for more modes than the shader includes take.
std::optional<ShaderCost> shaderOf(const Candidate& candidate, const std::vector<NamedShaderCost>& shaders);

/// Adds the table "representations" and the charts "representations" and "shaders".
void reportRepresentations(const bake::SkyFile& file, const StudyDay& day, const std::vector<Candidate>& candidates,
                           StudyReport& report);

}  // namespace welkin::study
