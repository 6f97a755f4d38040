# SPDX-License-Identifier: Apache-2.0
# Toolchain: Linux on ARM64 (Debian: g++-aarch64-linux-gnu); programs run under QEMU (qemu-user-static).
#   cmake -B build/arm64 --toolchain tools/cmake/arm64.cmake -DWELKIN_BUILD_TOOLS=OFF -DWELKIN_BUILD_TESTS=OFF
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
include(${CMAKE_CURRENT_LIST_DIR}/host_headers.cmake)
