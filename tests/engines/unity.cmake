# SPDX-License-Identifier: Apache-2.0
# Compiles the C# of docs/engines.md with its stand-ins by Mono, and runs it on the plugin. Prints "skipped: " without Mono.
#   cmake -DSOURCE=this folder -DWORK=folder with unity_code.cs.inc -DPLUGIN=libwelkin_plugin.so -P unity.cmake
find_program(mcs mcs NO_CACHE)
find_program(mono mono NO_CACHE)
if(NOT mcs OR NOT mono)
  message("skipped: mono-mcs is not installed")
  return()
endif()
file(READ ${WORK}/unity_code.cs.inc code)
file(WRITE ${WORK}/unity_code.cs "using System; using System.Runtime.InteropServices;\nstatic partial class Game {\n${code}}\n")
execute_process(COMMAND ${mcs} -warnaserror -out:${WORK}/unity.exe ${SOURCE}/unity_test.cs ${SOURCE}/unity_types.cs ${WORK}/unity_code.cs
  COMMAND_ERROR_IS_FATAL ANY)
get_filename_component(folder ${PLUGIN} DIRECTORY)
execute_process(COMMAND ${CMAKE_COMMAND} -E env MONO_PATH=${WORK} LD_LIBRARY_PATH=${folder} ${mono} ${WORK}/unity.exe
  COMMAND_ERROR_IS_FATAL ANY)
