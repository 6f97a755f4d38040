#!/bin/sh
# SPDX-License-Identifier: Apache-2.0
# One job of the array of bake_level.sh. Arguments: LEVEL.toml DIR SHARDS [OPTION...]
set -eu
level=$1 folder=$2 shards=$3
shift 3
exec "$WELKIN" bake "$level" -o "$folder" --shard "$SLURM_ARRAY_TASK_ID/$shards" \
  --threads "${SLURM_CPUS_PER_TASK:-0}" --progress plain "$@"
