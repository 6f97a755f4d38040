# SPDX-License-Identifier: Apache-2.0
# The way of a game team from a build to a running game: install, find_package, pkg-config, add_subdirectory.
#   cmake -DSOURCE=checkout -DBUILD=built -DWORK=scratch [-DCONFIG=Release] -P consumer_test.cmake
cmake_minimum_required(VERSION 3.25)

# run(what COMMAND...): runs a command, and fails the test when it fails. Leaves its output in `output`.
function(run what)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE text ERROR_VARIABLE text)
  if(NOT result EQUAL 0)
    message("${text}")
    message(FATAL_ERROR "${what}: exit status ${result}")
  endif()
  set(output "${text}" PARENT_SCOPE)
  message(STATUS "${what}: passed")
endfunction()

# refused(what text COMMAND...): fails the test unless the command fails and prints `text`, apart from line breaks.
function(refused what text)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE said ERROR_VARIABLE said)
  string(REGEX REPLACE "[ \n]+" " " said "${said}")
  string(FIND "${said}" "${text}" at)
  if(result EQUAL 0 OR at EQUAL -1)
    message(FATAL_ERROR "${what}: exit status ${result}, expected a failure that says '${text}'\n${said}")
  endif()
  message(STATUS "${what}: refused, as it should be")
endfunction()

function(expect what pattern)
  if(NOT output MATCHES "${pattern}")
    message(FATAL_ERROR "${what}: expected '${pattern}' in\n${output}")
  endif()
endfunction()

function(expect_not what pattern)
  if(output MATCHES "${pattern}")
    message(FATAL_ERROR "${what}: did not expect '${pattern}' in\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK})
set(game "${WORK}/the game")  # a space in the path: depfiles must escape it
file(COPY ${SOURCE}/tests/consumer/ DESTINATION "${game}")
set(configure ${CMAKE_COMMAND} -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_FIND_USE_PACKAGE_REGISTRY=OFF)

# An installation that was moved. No file in it may name the folder of the build or of the installation.
run("install" ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/first --config "${CONFIG}")
set(prefix ${WORK}/prefix)
file(RENAME ${WORK}/first ${prefix})
foreach(file bin/welkin include/welkin/welkin.h include/welkin/welkin.hpp include/welkin/welkin_vulkan.h
    include/welkin/types.h include/welkin/engines.h include/welkin/sky_constants.h include/welkin/welkin_vulkan.hpp include/welkin/bake.hpp
    include/welkin/level.h include/welkin/level.hpp include/welkin/volume.h include/welkin/volume_constants.h include/welkin/welkin_vulkan_volume.h include/welkin/welkin_vulkan_reflection.h
    share/doc/welkin/LICENSE share/doc/welkin/CHANGELOG.md share/doc/welkin/docs/runtime.md
    share/welkin/shaders/welkin/ambient.glsl share/welkin/shaders/welkin/modes.glsl share/welkin/shaders/welkin/reflected_sky.glsl
    share/welkin/shaders/welkin/modes_4.hlsl share/welkin/shaders/welkin/modes_8.hlsl share/welkin/shaders/welkin/modes_12.hlsl
    share/welkin/shaders/welkin/modes_4.wgsl share/welkin/shaders/welkin/modes_8.wgsl share/welkin/shaders/welkin/modes_12.wgsl
    share/welkin/shaders/welkin/sky_constants.h share/welkin/shaders/welkin/volume.glsl share/welkin/shaders/welkin/far.glsl share/welkin/shaders/welkin/volume_constants.h
    share/welkin/shaders/shared/formulas.glsl)
  if(NOT EXISTS ${prefix}/${file})
    message(FATAL_ERROR "install: ${file} is missing")
  endif()
endforeach()
file(GLOB_RECURSE texts ${prefix}/*.cmake ${prefix}/*.pc)
foreach(text IN LISTS texts)
  file(READ ${text} content)
  foreach(folder ${SOURCE} ${BUILD} ${WORK} /usr)
    string(FIND "${content}" "${folder}/" at)
    if(NOT at EQUAL -1)
      message(FATAL_ERROR "install: ${text} names ${folder}")
    endif()
  endforeach()
endforeach()

# find_package, the bake as a build step, and the game itself.
set(build ${WORK}/game_build)
run("configure the game" ${configure} -S "${game}" -B ${build} -DCMAKE_PREFIX_PATH=${prefix})
run("build the game" ${CMAKE_COMMAND} --build ${build})
expect("build the game" "Baking")
run("run the game" ${build}/game ${build}/data/sky.welkin)
message(STATUS "${output}")
run("stream the street" ${build}/stream ${build}/street)
message(STATUS "${output}")
run("second build" ${CMAKE_COMMAND} --build ${build})
expect("second build" "no work to do")

set(gradient "${game}/sky/gradient_sun.ppm")
execute_process(COMMAND ${CMAKE_COMMAND} -E sleep 0.1)
file(TOUCH "${gradient}")
run("build after a new date" ${CMAKE_COMMAND} --build ${build})
expect("build after a new date" "Baking")
expect_not("build after a new date" "Packing|Linking")
run("second build after a new date" ${CMAKE_COMMAND} --build ${build})
expect("second build after a new date" "no work to do")

file(SHA256 ${build}/data/sky.welkin before)
file(READ "${gradient}" content)
string(REPLACE "250" "200" content "${content}")
file(WRITE "${gradient}" "${content}")
run("build after new bytes" ${CMAKE_COMMAND} --build ${build})
expect("build after new bytes" "Baking.*Packing")
file(SHA256 ${build}/data/sky.welkin after)
if(before STREQUAL after)
  message(FATAL_ERROR "build after new bytes: the packed sky is the old one")
endif()
expect("build after new bytes" "Baking.*Packing the level")
file(READ "${game}/level/ground.obj" content)
string(REPLACE "0 0 60" "0 1 60" content "${content}")
file(WRITE "${game}/level/ground.obj" "${content}")
run("build after an edit of the level" ${CMAKE_COMMAND} --build ${build})
expect("build after an edit of the level" "Baking level.*Packing the level")
expect_not("build after an edit of the level" "Packing the game")
run("second build after an edit of the level" ${CMAKE_COMMAND} --build ${build})
expect("second build after an edit of the level" "no work to do")
run("run the game again" ${build}/game ${build}/data/sky.welkin 6)
file(REMOVE ${build}/baked/sky.welkin)
run("build after a removed output" ${CMAKE_COMMAND} --build ${build})
expect("build after a removed output" "Baking")
run("bake with the installed tool" ${prefix}/bin/welkin bake "${game}/sky/sky.toml" -o ${WORK}/baked --progress none)
run("bake in process" ${build}/editor "${game}/sky/sky.toml" ${WORK}/in_process ${WORK}/stopped)
run("bake for Unity with the installed tool" ${prefix}/bin/welkin bake "${game}/sky/sky.toml" -o ${WORK}/for_unity --progress none
  --target unity --cubemaps none)
run("compare with the tool" ${CMAKE_COMMAND} -E compare_files ${WORK}/in_process/sky.welkin ${WORK}/for_unity/sky.welkin)
run("clean" ${CMAKE_COMMAND} --build ${build} --target clean)
if(EXISTS ${build}/baked/sky.welkin OR EXISTS ${build}/baked/cubemaps OR EXISTS ${build}/baked_level/level.welkin
   OR EXISTS ${build}/baked_level/sectors)
  message(FATAL_ERROR "clean: baked files are left")
endif()

# pkg-config for a C program, with no other flags.
file(GLOB pc ${prefix}/lib*/pkgconfig ${prefix}/lib/*/pkgconfig)
list(JOIN pc ":" pc)
set(ENV{PKG_CONFIG_PATH} ${pc})
run("compile C with pkg-config" sh -c "cc -std=c11 -Wall -Wextra -pedantic -Werror '${game}/pkg_config.c' \
  -o '${WORK}/c_game' $(pkg-config --cflags --libs welkin-runtime)")
run("run the C program" ${WORK}/c_game ${WORK}/baked/sky.welkin)
run("pkg-config of the shaders" pkg-config --variable=shader_includedir welkin-vulkan)
string(STRIP "${output}" shaders)
if(NOT EXISTS ${shaders}/welkin/dome.glsl)
  message(FATAL_ERROR "pkg-config: shader_includedir is '${shaders}', which has no welkin/dome.glsl")
endif()
# The same program in C99, with the shared library, which exports the C interface and nothing else.
run("compile C99 with the shared library" sh -c "cc -std=c99 -Wall -Wextra -pedantic -Werror '${game}/pkg_config.c' \
  -o '${WORK}/c_shared' $(pkg-config --cflags --libs welkin-library) -Wl,-rpath,$(pkg-config --variable=libdir welkin-library)")
run("run with the shared library" ${WORK}/c_shared ${WORK}/baked/sky.welkin)
run("needs of the C99 program" readelf -d ${WORK}/c_shared)
expect("needs of the C99 program" "NEEDED[^\n]*libwelkin.so.0.2")
run("exports" sh -c "nm -D --defined-only $(pkg-config --variable=libdir welkin-library)/libwelkin.so | cut -d' ' -f3")
string(STRIP "${output}" exports)
string(REPLACE "\n" ";" exports "${exports}")
foreach(header welkin engines level volume welkin_vulkan welkin_vulkan_reflection welkin_vulkan_volume)
  file(STRINGS ${prefix}/include/welkin/${header}.h lines REGEX "^WELKIN_API ")
  foreach(line IN LISTS lines)
    string(REGEX MATCH "welkin_[a-z_0-9]+" function "${line}")
    list(APPEND declared ${function})
  endforeach()
endforeach()
list(SORT exports)
list(SORT declared)
if(NOT exports STREQUAL declared)
  message(FATAL_ERROR "the shared library exports ${exports}, the headers declare ${declared}")
endif()

# A game of C++17 with its own FlatBuffers: neither calls the other's.
run("compile C++17 with another FlatBuffers" sh -c "c++ -std=c++17 -Wall -Wextra -pedantic -Werror \
  '${game}/other_flatbuffers.cpp' -o '${WORK}/other' $(pkg-config --cflags --libs welkin-runtime)")
run("run with another FlatBuffers" ${WORK}/other ${WORK}/baked/sky.welkin)
run("symbols of the static library" sh -c "nm $(pkg-config --variable=libdir welkin-runtime)/libwelkin_runtime.a")
expect("symbols of the static library" "welkin_sky_open_file")
expect_not("symbols of the static library" "[^a-z_]11flatbuffers")
file(WRITE ${WORK}/header.cpp "#include <welkin/welkin_vulkan.hpp>\nint main() { welkin::VulkanSky sky; return sky ? 1 : 0; }\n")
run("compile the Vulkan wrapper as C++17" sh -c "c++ -std=c++17 -Wall -Wextra -pedantic -Werror '${WORK}/header.cpp' \
  -o '${WORK}/header' $(pkg-config --cflags --libs welkin-vulkan)")
file(WRITE ${WORK}/vulkan.c "#include <welkin/welkin_vulkan_reflection.h>\nint main(void) { welkin_vulkan_destroy(0); welkin_vulkan_reflection_destroy(0); return 0; }\n")
run("compile Vulkan C with pkg-config" sh -c "cc -std=c11 -Wall -Wextra -pedantic -Werror '${WORK}/vulkan.c' \
  -o '${WORK}/vulkan_c' $(pkg-config --cflags --libs welkin-vulkan)")

# A checkout inside the game's tree: the same project, the same calls.
run("configure with add_subdirectory" ${configure} -S "${game}" -B ${WORK}/subdirectory -DWELKIN_SOURCE=${SOURCE})
run("plan with add_subdirectory" ${CMAKE_COMMAND} --build ${WORK}/subdirectory -- -n game sky)
expect("plan with add_subdirectory" "Linking CXX executable [^\n]*welkin\n.*Baking")

# The libraries alone. CMake looks for no dependency of the tool, and the package names its missing components.
set(absent "")
foreach(package PkgConfig fmt OpenEXR TBB CLI11 nlohmann_json Catch2 embree)
  list(APPEND absent -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
run("configure the libraries" ${configure} ${absent} -S ${SOURCE} -B ${WORK}/libraries
  -DWELKIN_BUILD_TOOLS=OFF -DWELKIN_BUILD_TESTS=OFF)
run("build the libraries" ${CMAKE_COMMAND} --build ${WORK}/libraries)
run("install the libraries" ${CMAKE_COMMAND} --install ${WORK}/libraries --prefix ${WORK}/libraries_prefix)
file(WRITE ${WORK}/find/CMakeLists.txt "cmake_minimum_required(VERSION 3.25)\nproject(find LANGUAGES C CXX)
if(HIDE_LIBRARIES)\n  set(CMAKE_FIND_LIBRARY_SUFFIXES .none)\nendif()
find_package(Welkin \${WANTED_VERSION} REQUIRED CONFIG COMPONENTS \${WANTED})
if(NOT TARGET welkin::vulkan OR TARGET welkin::bake)\n  message(FATAL_ERROR \"wrong targets\")\nendif()\n")
set(find ${configure} -S ${WORK}/find -B ${WORK}/find_build -DCMAKE_PREFIX_PATH=${WORK}/libraries_prefix)
run("find the libraries" ${find} -DWANTED=vulkan -DWANTED_VERSION=0.2)
refused("component that is not installed" "component 'bake' is not in this installation, which has: runtime, vulkan, library"
  ${find} -DWANTED=bake -DWANTED_VERSION=0.2)
refused("component that is none" "there is no component 'vulcan', only runtime, vulkan, library, bake, baker"
  ${find} -DWANTED=vulcan -DWANTED_VERSION=0.2)
refused("another minor version" "version: 0.2." ${find} -DWANTED=runtime -DWANTED_VERSION=0.99)
refused("without Highway" "component 'runtime' needs the library hwy"
  ${find} -DWANTED=vulkan -DWANTED_VERSION=0.2 -DHIDE_LIBRARIES=ON -DWelkin_HIGHWAY_LIBRARY=NOTFOUND)
