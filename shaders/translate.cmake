# SPDX-License-Identifier: Apache-2.0
# Makes an include of HLSL or WGSL from the HLSL that spirv-cross writes of a whole shader. Drops the entry point and what
# belongs to it, and gives registers names. WGSL is rewritten from that HLSL line by line, for spirv-cross writes none: it
# knows the few forms that the source has, and tests/engines runs the result.
#   cmake -DFROM=whole.hlsl -DTO=modes_12.hlsl|modes_12.wgsl -DSOURCE=welkin/modes.glsl -DMODES=12 -P translate.cmake
cmake_minimum_required(VERSION 3.25)
file(READ ${FROM} text)
# A list would split the text at its semicolons and brackets, so only strings are used.
foreach(mark "static float4 colour;\n" "\nvoid frag_main()")
  if(NOT text MATCHES "${mark}")
    message(FATAL_ERROR "${FROM}: this spirv-cross writes no \"${mark}\": ${TO} cannot be made of it")
  endif()
endforeach()
string(REGEX REPLACE "\nvoid frag_main\\(\\).*" "" text "${text}")
string(REGEX REPLACE "static float[34] [a-z]+;\n+" "" text "${text}")
string(REGEX REPLACE "struct SPIRV_Cross_(In|Out)put\n{\n[^}]*};\n+" "" text "${text}")
string(REGEX REPLACE "_[0-9]+_welkinSky" "welkinSky" text "${text}")
string(REGEX REPLACE "normal_[0-9]+" "normal" text "${text}")
set(head "// SPDX-License-Identifier: Apache-2.0
// Ambient light of the sky from up to ${MODES} modes. A build makes this file from ${SOURCE}, by glslang and spirv-cross.
//   welkinModesIrradiance(normal)        irradiance, pi included, as welkin_sky_irradiance computes it
//   welkinModesIrradianceOverPi(normal)  that over pi: times an albedo the radiance of a diffuse surface
// `normal` is unit, in Welkin's axes. welkin_sky_constants fills the constants. The map is an array of 2D textures in
// RGBA16F: layer i has the modes 4i to 4i + 3 of welkin_sky_modes, and 0 past the last. The sampler is linear and clamps.
")

if(TO MATCHES "hlsl$")
  set(guard WELKIN_MODES_${MODES}_HLSL)
  set(registers "")
  foreach(name_register "CONSTANTS b0" "MODES t1" "MODES_SAMPLER s2")
    string(REPLACE " " ";" pair ${name_register})
    list(GET pair 0 name)
    list(GET pair 1 register)
    string(REPLACE "register(${register})" "register(WELKIN_REGISTER_${name})" text "${text}")
    string(APPEND registers "#ifndef WELKIN_REGISTER_${name}\n#define WELKIN_REGISTER_${name} ${register}\n#endif\n")
  endforeach()
  file(WRITE ${TO} "${head}// Define WELKIN_REGISTER_... before the include for other registers.
#ifndef ${guard}\n#define ${guard}\n\n${registers}\n${text}\n#endif\n")
  return()
endif()

foreach(count 2 3 4)
  string(REGEX REPLACE "float${count}([^a-z0-9_])" "vec${count}f\\1" text "${text}")
endforeach()
string(REGEX REPLACE "([^a-z_])float " "\\1f32 " text "${text}")
string(REGEX REPLACE "([^a-z_])int " "\\1i32 " text "${text}")
set(type "(vec[234]f|f32|i32|bool)")
set(name "([A-Za-z_][A-Za-z0-9_]*)")
# resources
string(REGEX REPLACE "cbuffer [A-Za-z]+ : register\\(b0\\)\n{[^}]*};" "@group(0) @binding(0) var<uniform> welkinSky: WelkinSkyConstants;" text "${text}")
string(REGEX REPLACE "Texture2DArray<vec4f> ${name} : register\\(t1\\);" "@group(0) @binding(1) var \\1: texture_2d_array<f32>;" text "${text}")
string(REGEX REPLACE "SamplerState ${name} : register\\(s2\\);" "@group(0) @binding(2) var \\1: sampler;" text "${text}")
# members of a struct, locals, functions and their parameters
string(REGEX REPLACE "\n    ${type} ${name}\\[([0-9]+)\\];" "\n    \\2: array<\\1, \\3>," text "${text}")
string(REGEX REPLACE "\n    ${type} ${name};" "\n    \\2: \\1," text "${text}")
string(REGEX REPLACE "\n    ${type} ${name} = " "\n    var \\2: \\1 = " text "${text}")
string(REGEX REPLACE "\n${type} ${name}(\\([^\n]*\\))\n{" "\nfn \\2\\3 -> \\1\n{" text "${text}")
string(REGEX REPLACE "([(]|, )${type} ${name}" "\\1\\3: \\2" text "${text}")
string(REPLACE "\n};" "\n}" text "${text}")
# expressions
string(REGEX REPLACE "([0-9.]+f)\\.xxx" "vec3f(\\1)" text "${text}")
string(REGEX REPLACE "\\(([a-z]+) \\? ([^:?]+) : ([^()]+)\\)" "select(\\3, \\2, \\1)" text "${text}")
string(REGEX REPLACE "${name}\\.SampleLevel\\(${name}, vec3f\\(${name}, ${name}\\), " "textureSampleLevel(\\1, \\2, \\3, i32(\\4), " text "${text}")
file(WRITE ${TO} "${head}// Change the groups and bindings of the three resources as your layout has them.\n\n${text}")
