#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# Bakes a level on a Slurm cluster: an array of jobs, one per shard, and a merge after the last of them.
#   tools/slurm/bake_level.sh LEVEL.toml DIR SHARDS [OPTION...]     OPTIONs of welkin bake; prints the merge's job id
# LEVEL.toml and DIR are on a file system that all nodes see. WELKIN names the program (default: welkin). SBATCH_OPTIONS
# holds further options of sbatch (partition, time, CPUs). The same command, run again, bakes only missing sectors.
set -eu
if [ $# -lt 3 ]; then
  echo "bake_level.sh LEVEL.toml DIR SHARDS [OPTION...]" >&2
  exit 1
fi
level=$1 folder=$2 shards=$3
shift 3
here=$(cd "$(dirname "$0")" && pwd)
export WELKIN="${WELKIN:-welkin}"
# shellcheck disable=SC2086
array=$(sbatch --parsable ${SBATCH_OPTIONS-} --array="0-$((shards - 1))" --job-name=welkin_bake \
  "$here/shard.sh" "$level" "$folder" "$shards" "$@")
# shellcheck disable=SC2086
sbatch --parsable ${SBATCH_OPTIONS-} --dependency="afterok:$array" --kill-on-invalid-dep=yes --job-name=welkin_merge \
  "$here/merge.sh" "$folder"
