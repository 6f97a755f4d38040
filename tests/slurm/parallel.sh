#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Bakes a level in shards by GNU parallel and merges them, as docs/level_file.md says, and compares with a bake in one
# process.
#   tests/slurm/parallel.sh WELKIN WORK       needs Debian's parallel; without: status 77
set -eu
welkin=$(readlink -f "$1")
rm -rf "$2"
mkdir -p "$2"
work=$(cd "$2" && pwd)
level="$(cd "$(dirname "$0")" && pwd)/../../examples/island/level.toml"
if ! command -v parallel >/dev/null; then
  echo "skipped: no GNU parallel here"
  exit 77
fi

seq 0 3 | parallel -j2 --halt soon,fail=1 "$welkin" bake "$level" -o "$work/farm" --threads 1 --progress none \
  --quality draft --certify none --shard '{}/4'
"$welkin" merge "$work/farm"
"$welkin" bake "$level" -o "$work/one" --progress none --quality draft --certify none
for file in sky.welkin level.welkin sectors; do
  diff -r "$work/one/$file" "$work/farm/$file"
done
echo "the same bytes by 4 shards and by one process: $(find "$work/farm/sectors" -name '*.welkin' | wc -l) sectors"
