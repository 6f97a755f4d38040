# SPDX-License-Identifier: Apache-2.0
# Toolchain: Windows on x86-64 by MinGW-w64 (Debian: g++-mingw-w64-x86-64-posix); programs run under Wine (wine64).
#   cmake -B build/windows --toolchain tools/cmake/windows.cmake -DWELKIN_BUILD_TOOLS=OFF -DWELKIN_BUILD_TESTS=OFF
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
# Programs and the DLL hold MinGW's own libraries.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
set(CMAKE_SHARED_LINKER_FLAGS_INIT -static)
include(${CMAKE_CURRENT_LIST_DIR}/host_headers.cmake)
