#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Prints a table of glTF files: read, warned of or refused, and the message. The files are asked for as a level of
# their own, by `welkin plan` and `welkin reference`.
#   tools/gltf_table.sh build/release/welkin FOLDER...
set -eu
welkin=$(realpath "$1")
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cat >"$work/sky.toml" <<'TOML'
[sky]
luminance = "cie-5"
normalise = "zenith"
intensity = 1
ground_albedo = [0, 0, 0]
[sun]
path = [[0, 180, 45]]
[bake]
cubemap_size = 0
keys = 1
TOML
echo "| file | what | message |"
echo "|---|---|---|"
find "$@" \( -name '*.gltf' -o -name '*.glb' \) | LC_ALL=C sort | while read -r file; do
  path=$(realpath "$file")
  printf '[level]\nsky = "sky.toml"\n[[geometry]]\nfile = "%s"\n' "$path" >"$work/level.toml"
  status=0
  timeout 60 "$welkin" plan "$work/level.toml" --progress none >/dev/null 2>"$work/said" || status=$?
  if [ "$status" = 0 ]; then
    timeout 60 "$welkin" reference "$work/level.toml" --time 12 --position 0,1,0 --normal 0,1,0 --samples 1024 \
      --progress none >/dev/null 2>"$work/said" || status=$?
  fi
  what=read
  [ -s "$work/said" ] && what=warned
  [ "$status" = 0 ] || what="refused ($status)"
  message=$(sed "s|$path|file|g; s|$(dirname "$path")/||g; s|$work/||g; s/^welkin: //; s/^warning: //; s/^file: //" \
    "$work/said" | head -4 | paste -sd ';' | sed 's/|/\\|/g; s/;/; /g')
  echo "| $(basename "$(dirname "$path")")/$(basename "$path") | $what | $message |"
done
