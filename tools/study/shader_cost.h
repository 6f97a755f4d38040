// SPDX-License-Identifier: Apache-2.0
// What the shader includes cost a pixel, counted in the SPIR-V that spirv-opt -O makes of them. These are counts and no
// times: the only device that every machine has is lavapipe, whose times say nothing about a GPU, while the counts
// order ways of doing the same thing on every GPU.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace welkin::study {

struct ShaderCost {
  int instructions = 0;       ///< that compute: arithmetic and library functions, once for all components
  int scalar_operations = 0;  ///< the same by component, which is how most GPUs run them; functions of whole vectors
                              ///< (normalize, length) count the numbers that they take or give, whichever are more
  int texture_fetches = 0;
  int uniform_loads = 0;  ///< distinct vectors or single numbers read from uniform blocks
};

/// Counts along the whole program with loops unrolled and, where a branch depends on data, both of its sides; what is
/// not needed for the result is not counted, nor are copies and swizzles. Throws Error(internal) for what it cannot
/// follow.
ShaderCost countShader(std::span<const std::uint32_t> spirv);

struct NamedShaderCost {
  /// "irradiance 2 bands" .. "irradiance 5 bands", "irradiance 4 modes", "irradiance 8 modes", "dome analytic", "dome
  /// cubemaps"
  std::string name;
  ShaderCost cost;
};

/// The costs of Welkin's own functions, less those of a shader that returns its input. In the order above.
std::vector<NamedShaderCost> measuredShaders();

}  // namespace welkin::study
