#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs what is missing, builds with warnings as errors and runs every test: the unit tests under the address and
# undefined-behaviour sanitizers first, then all tests of the release build. Ends with ctest's summary.
# Tests on real levels run when WELKIN_DATA names their folder.
set -eu
cd "$(dirname "$0")/.."

tools/setup.sh
export LP_NATIVE_VECTOR_WIDTH=256  # the width of Mesa's software rasteriser changes the last bits of cube sampling
[ -n "${WELKIN_DATA:-}" ] || echo "WELKIN_DATA is not set: tests on real levels are skipped"

cmake --preset asan -DWELKIN_WERROR=ON -DWELKIN_BUILD_TOOLS=ON >/dev/null
cmake --build --preset asan --target unit_tests
ctest --preset asan -L unit

cmake --preset release -DWELKIN_WERROR=ON -DWELKIN_BUILD_TESTS=ON >/dev/null
cmake --build --preset release
ctest --preset release
