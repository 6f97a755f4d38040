# SPDX-License-Identifier: Apache-2.0
# Compiles a GLSL file, optimises it, and writes a C array of its SPIR-V words that a target includes.
include(${PROJECT_SOURCE_DIR}/shaders/compile_shader.cmake)
find_program(WELKIN_SPIRV_OPT NAMES spirv-opt REQUIRED)
set(WELKIN_WRITE_WORDS ${CMAKE_CURRENT_LIST_DIR}/write_words.cmake CACHE INTERNAL "Script that writes SPIR-V as C")

# welkin_optimise_shader(TARGET SOURCE NAME [DEFINITION...]): SOURCE is relative to the calling folder.
# TARGET can then include "spirv/NAME.h", which declares `const uint32_t NAME[]` (include <cstdint> before it).
function(welkin_optimise_shader target source name)
  get_filename_component(source ${source} ABSOLUTE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
  set(header ${folder}/spirv/${name}.h)
  file(MAKE_DIRECTORY ${folder}/spirv)
  list(TRANSFORM ARGN PREPEND -D)
  add_custom_command(OUTPUT ${header}
    COMMAND ${WELKIN_GLSLANG} --quiet --target-env vulkan1.2 -V -g0 ${ARGN} -I${WELKIN_SHADER_DIR}
            --depfile ${header}.d -o ${header} ${source}
    COMMAND ${WELKIN_SPIRV_OPT} -O ${header} -o ${header}.spv
    COMMAND ${CMAKE_COMMAND} -DFROM=${header}.spv -DTO=${header} -DNAME=${name} -P ${WELKIN_WRITE_WORDS}
    DEPENDS ${source} ${WELKIN_WRITE_WORDS} DEPFILE ${header}.d VERBATIM
    COMMENT "Optimising shader ${name}")
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
