#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Compares the ambient light of frames with the path tracer, and with the CPU's look-ups, pixel by pixel: the talk's
# levels, and the island at eight hours. Prints the table of docs/probes.md.
# shellcheck disable=SC2154  # eval sets the numbers
#   tools/frame_errors.sh WELKIN FOLDER      FOLDER of the bakes; what is up to date there stays
set -eu
welkin=$1
out=$2
examples=$(dirname "$0")/../examples

# The numbers of one run of `render --json`, in percent, as NAME_WHAT=value.
numbers() {
  awk '/": [{]/ { split($0, part, "\""); name = part[2] }
       /"(mean|rms|worst|noise)":/ { split($0, part, "\""); sub(/.*: /, ""); sub(/,/, "")
         gsub("-", "_", name); printf "%s_%s=%.1f\n", part[2] == "noise" ? "tracer" : name, part[2], 100 * $0 }'
}

# row LEVEL.toml BAKE NAME HOUR OPTIONS...
row() {
  level=$1 bake=$2 name=$3 hour=$4
  shift 4
  set -- "$out/$bake" --level "$level" --time "$hour" --size 240x135 --paths 32 --component ambient --progress none --json \
    -o "$out/frame.png" "$@"
  eval "$("$welkin" render "$@" --compare --occlusion none 2>/dev/null | numbers)"
  without="$probes_rms, $probes_mean, $probes_worst"
  between="$frame_to_query_mean, $frame_to_query_rms, $frame_to_query_worst"
  eval "$("$welkin" render "$@" --difference --occlusion screen 2>/dev/null | numbers)"
  echo "| $name | $hour | $nothing_rms, $nothing_worst | $flat_rms, $flat_mean, $flat_worst |" \
    "$query_rms, $query_mean, $query_worst | $without | $probes_rms, $probes_mean, $probes_worst | $between | $tracer_noise |"
}

for level in talk/walls/level talk/yard/level talk/lamp/level talk/lamp/without island/level; do
  "$welkin" bake "$examples/$level.toml" -o "$out/$level" --cubemaps none --progress none 2>/dev/null
done
echo "| level | hour | nothing | flat | query | frame | frame with occlusion | frame against query | noise |"
echo "|---|---|---|---|---|---|---|---|---|"
for hour in 9 15; do
  row "$examples/talk/walls/level.toml" talk/walls/level walls $hour --camera=32,4,50 --yaw 0 --pitch -6 --fov 45
done
for hour in 12 0; do
  row "$examples/talk/yard/level.toml" talk/yard/level yard $hour --camera=25,3,44 --yaw 25 --pitch -4 --fov 50
done
for level in level without; do
  row "$examples/talk/lamp/$level.toml" talk/lamp/$level "lamp, $level.toml" 0 --camera=37,3.5,44 --yaw -12 --pitch -6 --fov 50 \
    --light 29,2.5,32,20,14,7
done
for hour in 0 3 6 9 12 15 18 21; do
  row "$examples/island/level.toml" island/level island $hour --camera=-24,3.2,58 --yaw 32 --pitch 1 --fov 55
done
