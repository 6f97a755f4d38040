# SPDX-License-Identifier: Apache-2.0
# Baking as a step of a game's build; part of the package's component `bake`, and of the source tree.

# welkin_add_bake(TARGET name SKY sky.toml OUTPUT dir [OPTIONS option...])
# A target of the default build that runs `welkin bake SKY -o OUTPUT OPTIONS`. SKY is relative to the calling source
# folder, OUTPUT to its binary folder. Its property WELKIN_SKY is the path of the baked file: what depends on that file
# runs after the bake. Rebakes when the sky file, an image that it names or the tool has a new date; with Ninja, what
# depends on the baked file runs again only if its bytes changed.
function(welkin_add_bake)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;SKY;OUTPUT" "OPTIONS")
  foreach(name TARGET SKY OUTPUT)
    if(NOT arg_${name})
      message(FATAL_ERROR "welkin_add_bake: ${name} is missing; "
        "welkin_add_bake(TARGET name SKY sky.toml OUTPUT dir [OPTIONS option...])")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "welkin_add_bake: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT TARGET welkin::bake)
    message(FATAL_ERROR "welkin_add_bake: there is no target welkin::bake; ask for it with "
      "find_package(Welkin COMPONENTS bake), or in a source tree with WELKIN_BUILD_TOOLS=ON")
  endif()
  foreach(option IN LISTS arg_OPTIONS)
    if(option MATCHES "^(-o.*|--depfile.*)$")
      message(FATAL_ERROR "welkin_add_bake: OPTIONS has ${option}, which the function sets itself")
    endif()
  endforeach()

  cmake_path(ABSOLUTE_PATH arg_SKY NORMALIZE OUTPUT_VARIABLE sky)
  cmake_path(ABSOLUTE_PATH arg_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE OUTPUT_VARIABLE folder)
  string(REGEX REPLACE "/+$" "" folder ${folder})
  set(options ${arg_OPTIONS})
  set(byproducts ${folder}/sky.json ${folder}/timing.json)
  if(NOT options MATCHES "--report")
    list(APPEND byproducts ${folder}/report.json)
  endif()
  if(NOT options MATCHES "--progress")
    list(APPEND options --progress none)
  endif()
  # The tool leaves files alone that would not change. Ninja knows; others compare dates.
  set(touch "")
  if(NOT CMAKE_GENERATOR MATCHES "Ninja")
    set(touch COMMAND ${CMAKE_COMMAND} -E touch ${folder}/sky.welkin)
  endif()
  set(depfile ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${arg_TARGET}.welkin.d)
  add_custom_command(
    OUTPUT ${folder}/sky.welkin
    BYPRODUCTS ${byproducts}
    COMMAND $<TARGET_FILE:welkin::bake> bake ${sky} -o ${folder} --depfile ${depfile} ${options} ${touch}
    DEPENDS ${sky} $<TARGET_FILE:welkin::bake>
    DEPFILE ${depfile}
    COMMENT "Baking ${arg_SKY}"
    VERBATIM)
  add_custom_target(${arg_TARGET} ALL DEPENDS ${folder}/sky.welkin)
  set_target_properties(${arg_TARGET} PROPERTIES
    WELKIN_SKY ${folder}/sky.welkin
    ADDITIONAL_CLEAN_FILES ${folder}/cubemaps)
endfunction()
