# SPDX-License-Identifier: Apache-2.0
# Baking as a step of a game's build. The package's component `bake` and the source tree both offer it.

# welkin_add_bake(TARGET name <SKY sky.toml | LEVEL level.toml> OUTPUT dir [OPTIONS option...])
# Adds a target of the default build that runs `welkin bake FILE -o OUTPUT OPTIONS`. FILE is relative to the calling
# source folder, OUTPUT to its binary folder. The target's property WELKIN_SKY is the path of the baked sky. WELKIN_LEVEL
# is the path of a level's index, which changes with any of the level's files. Commands that depend on either path run
# after the bake. The target bakes again when the file, a file that it names or the tool has a new date. With Ninja,
# commands that depend on a baked file run again only if its bytes changed.
function(welkin_add_bake)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;SKY;LEVEL;OUTPUT" "OPTIONS")
  set(usage "welkin_add_bake(TARGET name <SKY sky.toml | LEVEL level.toml> OUTPUT dir [OPTIONS option...])")
  foreach(name TARGET OUTPUT)
    if(NOT arg_${name})
      message(FATAL_ERROR "welkin_add_bake: ${name} is missing; ${usage}")
    endif()
  endforeach()
  if((arg_SKY AND arg_LEVEL) OR NOT (arg_SKY OR arg_LEVEL))
    message(FATAL_ERROR "welkin_add_bake: needs either SKY or LEVEL; ${usage}")
  endif()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "welkin_add_bake: unknown arguments: ${arg_UNPARSED_ARGUMENTS}")
  endif()
  if(NOT TARGET welkin::bake)
    message(FATAL_ERROR "welkin_add_bake: there is no target welkin::bake; ask for it with "
      "find_package(Welkin COMPONENTS bake), or in a source tree with WELKIN_BUILD_TOOLS=ON")
  endif()
  foreach(option IN LISTS arg_OPTIONS)
    if(option MATCHES "^(-o.*|--depfile.*|--shard.*|--sectors.*)$")
      message(FATAL_ERROR "welkin_add_bake: OPTIONS has ${option}, which is the function's own, or leaves the output unfinished")
    endif()
  endforeach()

  set(file ${arg_SKY}${arg_LEVEL})
  cmake_path(ABSOLUTE_PATH file NORMALIZE OUTPUT_VARIABLE path)
  cmake_path(ABSOLUTE_PATH arg_OUTPUT BASE_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR} NORMALIZE OUTPUT_VARIABLE folder)
  string(REGEX REPLACE "/+$" "" folder ${folder})
  if(path MATCHES "[#$]" AND CMAKE_GENERATOR MATCHES "Ninja")
    message(WARNING "welkin_add_bake: ${path}: CMake does not quote # and $ in dependency files for Ninja, so this file "
      "is baked in every build; give it another name")
  endif()
  set(options ${arg_OPTIONS})
  set(byproducts ${folder}/sky.json ${folder}/timing.json)
  set(output ${folder}/sky.welkin)
  set(index "")
  if(arg_LEVEL)
    set(output ${folder}/level.welkin)
    set(index ${output})
    list(APPEND byproducts ${folder}/sky.welkin)
  endif()
  if(NOT options MATCHES "--report")
    list(APPEND byproducts ${folder}/report.json)
  endif()
  if(NOT options MATCHES "--progress")
    list(APPEND options --progress none)
  endif()
  # The tool does not write files that would not change. Ninja handles that; other generators compare dates.
  set(touch "")
  if(NOT CMAKE_GENERATOR MATCHES "Ninja")
    set(touch COMMAND ${CMAKE_COMMAND} -E touch ${output})
  endif()
  set(depfile ${CMAKE_CURRENT_BINARY_DIR}/CMakeFiles/${arg_TARGET}.welkin.d)
  add_custom_command(
    OUTPUT ${output}
    BYPRODUCTS ${byproducts}
    COMMAND $<TARGET_FILE:welkin::bake> bake ${path} -o ${folder} --depfile ${depfile} ${options} ${touch}
    DEPENDS ${path} $<TARGET_FILE:welkin::bake>
    DEPFILE ${depfile}
    COMMENT "Baking ${file}"
    VERBATIM)
  add_custom_target(${arg_TARGET} ALL DEPENDS ${output})
  set_target_properties(${arg_TARGET} PROPERTIES
    WELKIN_SKY ${folder}/sky.welkin
    WELKIN_LEVEL "${index}"
    ADDITIONAL_CLEAN_FILES "${folder}/cubemaps;${folder}/sectors")
endfunction()
