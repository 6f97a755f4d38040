// SPDX-License-Identifier: Apache-2.0
// Cost of the shader includes a pixel, counted in SPIR-V. These are counts and no times: the only device that every
// machine has is lavapipe, whose times say nothing about a GPU. Counts order shaders of the same purpose on every GPU.
// optimise_shader.cmake makes the SPIR-V: spirv-opt -O with every loop of constant bounds unrolled.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace welkin::study {

/// Static counts: every instruction of the module counts once, on both sides of a branch too. Copies, swizzles, phis
/// and branches are free.
struct ShaderCost {
  int instructions = 0;       ///< arithmetic, comparisons, selections, conversions and library functions
  int scalar_operations = 0;  ///< the same by component, which is how most GPUs run them: the components of the result
                              ///< or of the longest operand, whichever are more (dot and length take whole vectors)
  int texture_fetches = 0;
  int uniform_loads = 0;  ///< vectors or single numbers loaded from uniform blocks
};

/// Counts a module of one function. Throws Error(internal) for words that are no such module, and for a loop that is
/// not unrolled: its count would depend on data.
ShaderCost countShader(std::span<const std::uint32_t> spirv);

struct NamedShaderCost {
  /// "irradiance 2 bands" .. "irradiance 5 bands", "irradiance 4 modes", "irradiance 8 modes", "dome analytic", "dome
  /// cubemaps"
  std::string name;
  ShaderCost cost;
};

/// The costs of Welkin's own functions, in the order above.
std::vector<NamedShaderCost> measuredShaders();

}  // namespace welkin::study
