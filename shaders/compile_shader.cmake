# SPDX-License-Identifier: Apache-2.0
# Compiles a GLSL file into a C array of SPIR-V words that a target includes.
find_program(WELKIN_GLSLANG NAMES glslangValidator glslang REQUIRED)
set(WELKIN_SHADER_DIR ${CMAKE_CURRENT_LIST_DIR} CACHE INTERNAL "Folder of welkin/*.glsl and shared/*.glsl")

# welkin_compile_shader(TARGET SOURCE NAME [DEFINITION...])
# SOURCE is relative to the calling folder; its suffix gives the stage. Each DEFINITION is a macro, NAME or NAME=VALUE.
# The SPIR-V is of Vulkan 1.2: for 1.3 glslang writes LocalSizeId, which needs the feature maintenance4.
# TARGET can then include "spirv/NAME.h", which declares `const uint32_t NAME[]` (include <cstdint> before it).
function(welkin_compile_shader target source name)
  get_filename_component(source ${source} ABSOLUTE)
  set(folder ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders)
  set(header ${folder}/spirv/${name}.h)
  file(MAKE_DIRECTORY ${folder}/spirv)
  list(TRANSFORM ARGN PREPEND -D)
  add_custom_command(OUTPUT ${header}
    COMMAND ${WELKIN_GLSLANG} --quiet --target-env vulkan1.2 -V --vn ${name} ${ARGN} -I${WELKIN_SHADER_DIR}
            --depfile ${header}.d -o ${header} ${source}
    DEPENDS ${source} DEPFILE ${header}.d VERBATIM
    COMMENT "Compiling shader ${name}")
  target_sources(${target} PRIVATE ${header})
  target_include_directories(${target} PRIVATE ${folder})
endfunction()
