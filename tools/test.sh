#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Installs missing packages, builds with warnings as errors and runs every test. First it builds with Clang and the
# address and undefined-behaviour sanitizers, and runs the unit tests and every fuzzer for half a minute. Then it runs
# all tests of GCC's release build, some unit tests twice: again with floating-point traps (label traps). Ends with
# ctest's summary. Tests on real levels need WELKIN_DATA, their folder.
#   tools/test.sh [--long]      --long: each fuzzer runs for 20 minutes; before the release build also the unit tests
#                               without optimisation, and the faults of tests/mutation
set -eu
cd "$(dirname "$0")/.."

long=""
seconds=30
seed=1  # set it to repeat a fault that CI found
case "${1-}" in
  '') ;;
  --long) long=1 seconds=1200 seed=0 ;;
  *) echo "tools/test.sh [--long]" >&2; exit 1 ;;
esac

tools/setup.sh --tests
export LP_NATIVE_VECTOR_WIDTH=256  # the width of Mesa's software rasteriser changes the last bits of cube sampling
[ -n "${WELKIN_DATA:-}" ] || echo "WELKIN_DATA is not set: tests on real levels are skipped"

cmake --preset fuzz -DWELKIN_WERROR=ON -DWELKIN_BUILD_TOOLS=ON -DWELKIN_FUZZ_SECONDS="$seconds" \
  -DWELKIN_FUZZ_SEED="$seed" >/dev/null
cmake --build --preset fuzz --target unit_tests fuzzers
ctest --preset fuzz -L 'unit|fuzz'

if [ -n "$long" ]; then
  cmake --preset debug -DWELKIN_WERROR=ON >/dev/null
  cmake --build --preset debug --target unit_tests
  ctest --preset debug -L unit
  tests/mutation/run.sh build/mutation
fi

cmake --preset release -DWELKIN_WERROR=ON -DWELKIN_BUILD_TESTS=ON >/dev/null
cmake --build --preset release
ctest --preset release
