#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Prints the table of glTF files in docs/level_geometry.md: how many are read, warned of or refused, and the message.
# Each file is a level of its own for `welkin plan`, `bake` and `render`. The message is that of the last one that ran.
# Messages that differ in names and numbers alone share a row, which shows the first one. Refusals of one or two files
# share one row.
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
for folder; do
  find "$folder" \( -name '*.gltf' -o -name '*.glb' \) | LC_ALL=C sort
done >"$work/files"
while read -r file; do
  path=$(realpath "$file")
  printf '[level]\nsky = "sky.toml"\noutside_files = "allow"\n[[geometry]]\nfile = "%s"\n' "$path" >"$work/level.toml"
  status=0
  timeout 600 "$welkin" plan "$work/level.toml" --progress none >/dev/null 2>"$work/said" || status=$?
  if [ "$status" = 0 ]; then
    timeout 600 "$welkin" bake "$work/level.toml" -o "$work/out" --quality draft --certify none --progress none >/dev/null \
      2>"$work/said" || status=$?
  fi
  if [ "$status" = 0 ]; then
    timeout 600 "$welkin" render "$work/out" --level "$work/level.toml" --time 12 --size 64x36 -o "$work/a.png" >/dev/null \
      2>"$work/said" || status=$?
    sed -i '/^device: /d' "$work/said"
  fi
  what=read
  [ -s "$work/said" ] && what=warned
  [ "$status" = 0 ] || what="refused ($status)"
  name=$(basename "$path")
  message=$(sed "s|$path|file|g; s|$(dirname "$path")/||g; s|$work/||g; s/^welkin: //; s/^warning: //; s/^file: //" \
    "$work/said" | head -4 | paste -sd ';' | tr '\t' ' ' | sed 's/|/\\|/g; s/;/; /g')
  printf '%s\t%s\t%s\n' "${name%.*}" "$what" "$message"
done <"$work/files" >"$work/rows"
LC_ALL=C sort -t "$(printf '\t')" -k2,2 -k3,3 -k1,1 "$work/rows" | LC_ALL=C awk -F '\t' '
  # A list of names with one more, each once; at most `most` of them.
  function with(list, name, most) {
    if (list == "") return name
    if (index(", " list ", ", ", " name ", ") > 0 || split(list, parts, ", ") >= most) return list
    return list ", " name
  }
  function short(text) { return length(text) > 160 ? substr(text, 1, 157) "..." : text }
  {
    kind = $2 "\t" $3
    gsub(/"[^"]*"/, "\"\"", kind)
    gsub(/[0-9]+(\.[0-9]+)?/, "0", kind)
    if (!(kind in count)) {
      order[++kinds] = kind
      what[kind] = $2
      first[kind] = $1
      message[kind] = $3
    }
    ++count[kind]
    names[kind] = with(names[kind], $1, $2 == "read" ? 1000 : 5)
  }
  END {
    print "| files | names | what | message |"
    print "|---|---|---|---|"
    for (i = 1; i <= kinds; ++i) {
      k = order[i]
      w = what[k]
      if (w !~ /^refused/ || count[k] > 2) {
        print "| " count[k] " | " names[k] " | " w " | " short(message[k]) " |"
        continue
      }
      if (!(w in others)) ways[++way_count] = w
      others[w] += count[k]
      if (++words[w] > 3) continue
      few[w] = with(few[w], first[k], 5)
      said[w] = said[w] (words[w] > 1 ? "; " : "") short(message[k])
    }
    for (i = 1; i <= way_count; ++i) {
      w = ways[i]
      print "| " others[w] " | " few[w] " | " w " | " words[w] " other messages, such as: " said[w] " |"
    }
  }'
