#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Makes pictures from a fresh clone: installs missing packages, builds, bakes examples/island, draws it over the day, and
# compares flat ambient light, probes and path tracer.
#   tools/demo.sh [FOLDER]      FOLDER of the outputs, build/demo by default
set -eu
cd "$(dirname "$0")/.."
out=${1:-build/demo}

tools/setup.sh
cmake --preset release -DWELKIN_BUILD_TESTS=OFF >/dev/null
cmake --build --preset release --target welkin
welkin=build/release/welkin

"$welkin" bake examples/island/level.toml -o "$out/island"
"$welkin" render "$out/island" -o "$out/sky.png" --view sheet \
  --time 1 --time 5.3 --time 6.2 --time 8.5 --time 12 --time 17 --time 18.5 --time 19.2
"$welkin" render "$out/island" -o "$out/island.png" --size 480x270 --camera=-28,2.6,62 --yaw 20 --pitch 2 --fov 55 \
  --time 5.4 --time 6.4 --time 9 --time 12 --time 16.3 --time 18.2 --time 18.8 --time 23
"$welkin" render "$out/island" -o "$out/beach.png" --size 960x540 --camera=-24,3.2,58 --yaw 32 --pitch 1 --fov 55 --time 16.3
"$welkin" render "$out/island" -o "$out/sunset.png" --size 960x540 --camera=10,5,70 --yaw -65 --pitch 1 --time 18.1
"$welkin" render "$out/island" -o "$out/wreck.png" --size 960x540 --camera=-48,3,-8 --yaw 42 --pitch 6 --fov 48 --time 18.3
# Small and with few paths, 72 a pixel: some 15 seconds of one processor.
"$welkin" render "$out/island" -o "$out/compared.png" --size 480x270 --camera=-24,3.2,58 --yaw 32 --pitch 1 --fov 55 --time 16.3 \
  --compare --paths 64
echo "pictures:"
echo "  $out/island.png  the island at eight times of day"
echo "  $out/sky.png     the same sky: the dome, the horizon, a sphere under flat and under SH ambient light"
echo "  $out/compared.png  the beach under flat light, by probes and by the path tracer, with the error of each"
ls "$out"/*.png
