// SPDX-License-Identifier: Apache-2.0
// The first axis of a study: bands and their reconstruction, modes and their maps. Error at exact keys against what a
// key, a sample and a pixel cost.
#pragma once

#include <optional>

#include "study/report.h"
#include "study/runtime_speed.h"
#include "study/shader_cost.h"

namespace welkin::study {

/// The ways of a study, in the order of its tables: bands, then modes. A quick one has a few.
std::vector<Way> collectWays(const StudyDay& day, const StudyOptions& options);

/// What the shader that reads a way costs; none for more modes than the shader includes take.
std::optional<ShaderCost> shaderOf(const Way& way, const std::vector<NamedShaderCost>& shaders);

/// Adds the table "ways" and the charts "ways" and "shaders".
void reportWays(const bake::SkyFile& file, const StudyDay& day, const std::vector<Way>& ways, StudyReport& report);

}  // namespace welkin::study
