# SPDX-License-Identifier: Apache-2.0
# Bakes a sky or level and compares the output of the programs that were compiled against earlier headers with today's.
#   cmake -DTOOL=welkin -DSKY=file.toml -DTODAY=program "-DEARLIER=program;..." -DWORK=scratch [-DFILES=sky.welkin;...]
#     [-DLEAST=characters] -P compare.cmake
# FILES are the programs' arguments, in the folder of the bake. Today's program prints at least LEAST characters.
cmake_minimum_required(VERSION 3.25)
if(NOT FILES)
  set(FILES sky.welkin)
endif()
if(NOT LEAST)
  set(LEAST 4000)
endif()
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${TOOL} bake ${SKY} -o ${WORK} --progress none COMMAND_ERROR_IS_FATAL ANY)
list(TRANSFORM FILES PREPEND ${WORK}/)
execute_process(COMMAND ${TODAY} ${FILES} OUTPUT_VARIABLE today COMMAND_ERROR_IS_FATAL ANY)
string(LENGTH "${today}" length)
if(length LESS LEAST)
  message(FATAL_ERROR "today's program printed only:\n${today}")
endif()
foreach(program IN LISTS EARLIER)
  execute_process(COMMAND ${program} ${FILES} OUTPUT_VARIABLE earlier COMMAND_ERROR_IS_FATAL ANY)
  if(NOT earlier STREQUAL today)
    message(FATAL_ERROR "${program} printed\n${earlier}\nwhere today's program printed\n${today}")
  endif()
endforeach()
