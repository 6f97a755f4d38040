# SPDX-License-Identifier: Apache-2.0
# Bakes a sky and compares the output of the programs that were compiled against earlier headers with today's.
#   cmake -DTOOL=welkin -DSKY=sky.toml -DTODAY=program "-DEARLIER=program;..." -DWORK=scratch -P compare.cmake
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${WORK})
execute_process(COMMAND ${TOOL} bake ${SKY} -o ${WORK} --progress none COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${TODAY} ${WORK}/sky.welkin OUTPUT_VARIABLE today COMMAND_ERROR_IS_FATAL ANY)
string(LENGTH "${today}" length)
if(length LESS 4000)
  message(FATAL_ERROR "today's program printed only:\n${today}")
endif()
foreach(program IN LISTS EARLIER)
  execute_process(COMMAND ${program} ${WORK}/sky.welkin OUTPUT_VARIABLE earlier COMMAND_ERROR_IS_FATAL ANY)
  if(NOT earlier STREQUAL today)
    message(FATAL_ERROR "${program} printed\n${earlier}\nwhere today's program printed\n${today}")
  endif()
endforeach()
