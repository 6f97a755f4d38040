# SPDX-License-Identifier: Apache-2.0
# Builds tests/sky/same_bytes for ARM64 and runs it under QEMU: what is baked there has the checksums of x86-64. Prints
# "skipped: " when the compiler, the emulator or the libraries are missing.
#   cmake -DSOURCE=checkout -DGENERATED=folder of welkin_generated.h -DPACKAGES=folder that tools/setup.sh --tests unpacks
#     -DEIGEN=definitions of Eigen -DWORK=scratch -P same_bytes.cmake
cmake_minimum_required(VERSION 3.25)
find_program(cxx aarch64-linux-gnu-g++)
find_program(emulator qemu-aarch64-static)
if(NOT cxx OR NOT emulator)
  message("skipped: this needs the packages g++-aarch64-linux-gnu qemu-user-static")
  return()
endif()
set(arm ${PACKAGES}/usr/include/aarch64-linux-gnu)
if(NOT EXISTS ${arm}/sleef.h)
  message("skipped: the libraries of ARM64 are not in ${PACKAGES}: run tools/setup.sh --tests")
  return()
endif()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE errors)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}: ${result}\n${text}${errors}")
  endif()
endfunction()

# Headers alone, which serve every processor. SLEEF's does not: it is the unpacked one.
file(MAKE_DIRECTORY ${WORK}/headers)
foreach(header flatbuffers fmt Imath oneapi OpenEXR tbb toml++ xxhash.h)
  file(CREATE_LINK /usr/include/${header} ${WORK}/headers/${header} SYMBOLIC)
endforeach()
list(TRANSFORM EIGEN PREPEND -D)
set(flags -std=c++20 -O2 -ffp-contract=off -fno-tree-slp-vectorize -Wall -Wextra -Werror -Dflatbuffers=welkin_flatbuffers ${EIGEN}
  -I${SOURCE} -I${SOURCE}/runtime -I${SOURCE}/shaders/shared -isystem ${arm} -isystem ${WORK}/headers -isystem ${WORK}/headers/Imath
  -isystem /usr/include/eigen3 -isystem ${GENERATED})

# Each folder is one source, as in a unity build.
set(sh arithmetic basis cube_weights environment exchange latlong minimax modes quadrature rotation)
set(sky/model gradient hemisphere indicatrix_table irradiance light luminance projection sky)
set(sky/table day_encoding day_fields day_table key_placement mode_map modes plan representation)
set(sky/cubemap cubemap exr)
set(sky/bake encode)
set(sky/base progress)
set(runtime/format container cubemap_format key_segment)
set(tests/sky same_bytes)
set(objects "")
foreach(folder sh sky/model sky/table sky/cubemap sky/bake sky/base runtime/format tests/sky)
  set(unity "")
  foreach(name IN LISTS ${folder})
    string(APPEND unity "#include \"${SOURCE}/${folder}/${name}.cpp\"\n")
  endforeach()
  string(REPLACE / _ name ${folder})
  file(WRITE ${WORK}/${name}.cpp "${unity}")
  run(${cxx} ${flags} -c ${WORK}/${name}.cpp -o ${WORK}/${name}.o)
  list(APPEND objects ${WORK}/${name}.o)
endforeach()

set(folders ${PACKAGES}/usr/lib/aarch64-linux-gnu ${PACKAGES}/lib/aarch64-linux-gnu)
list(JOIN folders : path)
list(TRANSFORM folders PREPEND -L OUTPUT_VARIABLE search)
set(libraries sleef.so.3 tbb.so.12 fmt.so.9 xxhash.so.0 OpenEXR-3_1.so.30 IlmThread-3_1.so.30 Iex-3_1.so.30 Imath-3_1.so.29)
list(TRANSFORM libraries PREPEND -l:lib)
run(${cxx} ${objects} ${search} -Wl,-rpath-link,${path} ${libraries} -o ${WORK}/same_bytes)
execute_process(COMMAND ${emulator} -L /usr/aarch64-linux-gnu -E LD_LIBRARY_PATH=${path} ${WORK}/same_bytes
  ${SOURCE}/tests/golden/same_bytes.txt 2 RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE errors)
message("${output}${errors}")
if(NOT result EQUAL 0 OR NOT output MATCHES "colourful.welkin [0-9a-f]")
  message(FATAL_ERROR "same_bytes on ARM64 ends with ${result}")
endif()
