# SPDX-License-Identifier: Apache-2.0
# Runs a fuzzer. After a finding it prints the command that repeats it. New inputs go to WORK; INPUTS are only read.
file(REMOVE_RECURSE ${WORK}/found)
file(MAKE_DIRECTORY ${WORK}/corpus ${WORK}/found)
execute_process(COMMAND ${PROGRAM} ${OPTIONS} -artifact_prefix=${WORK}/found/ ${WORK}/corpus ${INPUTS}
  RESULT_VARIABLE result)
file(GLOB found ${WORK}/found/*)
list(JOIN found " " found)
if(NOT result EQUAL 0 AND found)
  message(FATAL_ERROR "Found something; repeat it with:\n  ${PROGRAM} ${found}")
elseif(NOT result EQUAL 0)
  list(JOIN OPTIONS " " options)
  list(JOIN INPUTS " " inputs)
  message(FATAL_ERROR "Failed (${result}); repeat it with:\n  ${PROGRAM} ${options} ${WORK}/corpus ${inputs}")
elseif(found)  # measured by the wall clock of a machine that may have been busy
  message(STATUS "Perhaps slow; repeat it with:\n  ${PROGRAM} ${found}")
endif()
