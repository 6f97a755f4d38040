#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Compares the ambient light of frames with the path tracer, and with the CPU's look-ups, pixel by pixel: the talk's
# levels, the island at eight hours, and truck_town where WELKIN_DATA names a folder with it. Prints the table of
# docs/probes.md.
# shellcheck disable=SC2154  # eval sets the numbers
#   tools/frame_errors.sh WELKIN FOLDER [LEVEL..]      FOLDER of the bakes; what is up to date there stays
set -eu
welkin=$1
out=$2
shift 2
wanted=${*:-walls yard lamp island truck_town}
examples=$(dirname "$0")/../examples

# The numbers of one run of `render --json`, in percent, as NAME_WHAT=value.
numbers() {
  awk '/": [{]/ { split($0, part, "\""); name = part[2] }
       /"(mean|rms|worst|noise)":/ { split($0, part, "\""); sub(/.*: /, ""); sub(/,/, "")
         gsub("-", "_", name); printf "%s_%s=%.1f\n", part[2] == "noise" ? "tracer" : name, part[2], 100 * $0 }'
}

# row BAKE NAME HOUR OPTIONS...
row() {
  bake=$1 name=$2 hour=$3
  shift 3
  set -- "$out/$bake" --time "$hour" --size 240x135 --paths 32 --component ambient --progress none --json \
    -o "$out/frame.png" "$@"
  eval "$("$welkin" render "$@" --compare --occlusion none 2>/dev/null | numbers)"
  without="$probes_rms, $probes_mean, $probes_worst"
  between="$frame_to_query_mean, $frame_to_query_rms, $frame_to_query_worst"
  eval "$("$welkin" render "$@" --difference --occlusion screen 2>/dev/null | numbers)"
  echo "| $name | $hour | $nothing_rms, $nothing_worst | $flat_rms, $flat_mean, $flat_worst |" \
    "$query_rms, $query_mean, $query_worst | $without | $probes_rms, $probes_mean, $probes_worst | $between | $tracer_noise |"
}

bake() {
  "$welkin" bake "$1" -o "$2" --cubemaps none --progress none 2>/dev/null
}

# The [[geometry]] of every node of truck_town whose name begins with NODE: placed NODE FILE METRES MORE. Nodes have yaw and one scale,
# and METRES is that of the file.
placed() {
  awk -v node="$1" -v file="$2" -v metres="$3" -v more="$4" '
    /^\[node/ { wanted = $0 ~ ("name=\"" node "[0-9]*\" parent") }
    wanted && /^transform = Transform3D/ {
      gsub(/.*\(|\)/, ""); split($0, m, ", ")
      printf "[[geometry]]\nfile = \"%s\"\ntranslation = [%s, %s, %s]\n", file, m[10], m[11], m[12]
      printf "rotation_deg = [0, %.6f, 0]\nscale = %s\n%s\n", atan2(m[3], m[1]) * 57.29577951308232, metres * m[5], more
      wanted = 0 }' "$town/town_scene.tscn"
}

level() {
  case $1 in
    walls)
      bake "$examples/talk/walls/level.toml" "$out/walls"
      for hour in 9 15; do
        row walls walls $hour --camera=32,4,50 --yaw 0 --pitch -6 --fov 45
      done ;;
    yard)
      bake "$examples/talk/yard/level.toml" "$out/yard"
      for hour in 12 0; do
        row yard yard $hour --camera=25,3,44 --yaw 25 --pitch -4 --fov 50
      done ;;
    lamp)
      for level in level without; do
        bake "$examples/talk/lamp/$level.toml" "$out/lamp_$level"
        row "lamp_$level" "lamp, $level.toml" 0 --camera=37,3.5,44 --yaw -12 --pitch -6 --fov 50 --light 29,2.5,32,20,14,7
      done ;;
    island)
      bake "$examples/island/level.toml" "$out/island"
      for hour in 0 3 6 9 12 15 18 21; do
        row island island $hour --camera=-24,3.2,58 --yaw 32 --pitch 1 --fov 55
      done ;;
    truck_town)
      town=${WELKIN_DATA:-}/levels/truck_town/town
      test -d "$town" || { echo "truck_town is skipped: WELKIN_DATA names no folder with levels/truck_town" >&2; return; }
      mkdir -p "$out/town"
      cp "$examples"/island/sky.toml "$examples"/island/*.png "$out/town"
      {
        printf '[level]\nsky = "sky.toml"\n[probes]\nwithin = [[-127, 0, -127, 127, 1, 127]]\n'
        printf '[[geometry]]\nfile = "%s"\n' "$town/model/town_model.gltf"
        placed Tree "$town/tree/scene.gltf" 0.01 'role = "vegetation"'
        placed Lamp "$town/lamp/scene.gltf" 1 ''
      } > "$out/town/level.toml"
      bake "$out/town/level.toml" "$out/town/baked"
      for hour in 9 12 15; do
        row town/baked truck_town $hour --camera=45,15,35 --yaw -50 --pitch -6 --fov 55
      done ;;
    *) echo "$1: is none of walls, yard, lamp, island, truck_town" >&2; exit 1 ;;
  esac
}

echo "| level | hour | nothing | flat | query | frame | frame with occlusion | frame against query | noise |"
echo "|---|---|---|---|---|---|---|---|---|"
for name in $wanted; do
  level "$name"
done
