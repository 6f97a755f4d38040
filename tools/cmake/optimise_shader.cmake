# SPDX-License-Identifier: Apache-2.0
# Compiles a GLSL file, unrolls its loops, optimises it, and writes a C array of its SPIR-V words that a target includes.
include(${PROJECT_SOURCE_DIR}/shaders/compile_shader.cmake)
find_program(WELKIN_SPIRV_OPT NAMES spirv-opt REQUIRED)
set(WELKIN_WRITE_WORDS ${CMAKE_CURRENT_LIST_DIR}/write_words.cmake CACHE INTERNAL "Script that writes SPIR-V as C")

# spirv-opt unrolls the loops that are marked so: a macro marks each one, which the includes of a game leave to the driver.
# The source needs GL_EXT_control_flow_attributes. Each round unrolls the innermost loops whose bounds the one before made
# constant; redundant loads go last.
set(WELKIN_UNROLL -O --loop-unroll -O --loop-unroll -O --redundancy-elimination -O CACHE INTERNAL "Passes of spirv-opt")

# welkin_optimise_shader(TARGET SOURCE NAME [DEFINITION...]): SOURCE is relative to the calling folder.
# TARGET can then include "spirv/NAME.h", which declares `const uint32_t NAME[]` (include <cstdint> before it).
function(welkin_optimise_shader target source name)
  get_filename_component(source ${source} ABSOLUTE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
  set(header ${folder}/spirv/${name}.h)
  file(MAKE_DIRECTORY ${folder}/spirv)
  list(TRANSFORM ARGN PREPEND -D)
  add_custom_command(OUTPUT ${header}
    COMMAND ${WELKIN_GLSLANG} --quiet --target-env vulkan1.2 -V -g0 "-Dfor=[[unroll]] for" ${ARGN} -I${WELKIN_SHADER_DIR}
            --depfile ${header}.d -o ${header} ${source}
    COMMAND ${WELKIN_SPIRV_OPT} ${WELKIN_UNROLL} ${header} -o ${header}.spv
    COMMAND ${CMAKE_COMMAND} -DFROM=${header}.spv -DTO=${header} -DNAME=${name} -P ${WELKIN_WRITE_WORDS}
    DEPENDS ${source} ${WELKIN_WRITE_WORDS} DEPFILE ${header}.d VERBATIM
    COMMENT "Optimising shader ${name}")
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
