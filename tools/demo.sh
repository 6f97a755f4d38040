#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# From a fresh clone to pictures: installs what is missing, builds, bakes examples/island, draws its sky over the day.
#   tools/demo.sh [FOLDER]      FOLDER of the outputs, build/demo when left out
set -eu
cd "$(dirname "$0")/.."
out=${1:-build/demo}

tools/setup.sh
cmake --preset release -DWELKIN_BUILD_TESTS=OFF >/dev/null
cmake --build --preset release --target welkin
welkin=build/release/welkin

"$welkin" bake examples/island/sky.toml -o "$out/island"
"$welkin" render "$out/island" -o "$out/sky.png" --view sheet \
  --time 1 --time 5.3 --time 6.2 --time 8.5 --time 12 --time 17 --time 18.5 --time 19.2
for hour in 6.2 12 18.5 22; do
  "$welkin" render "$out/island" -o "$out/horizon_$hour.png" --view horizon --time "$hour" --size 960x540
done
echo "pictures: $out/sky.png (eight times of day: the dome, the horizon, spheres under flat and SH ambient light)"
ls "$out"/*.png
