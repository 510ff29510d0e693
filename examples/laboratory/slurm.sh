#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# sbatch --array=0-199 slurm.sh 200 RESULTS [ARGUMENTS of gloam check]: a task for each of 200 shards, a file of results
# from each. A task whose node died is queued again, and goes on where it was. Then: gloam report RESULTS/*.json
#SBATCH --job-name=gloam --requeue --open-mode=append --output=gloam-%A_%a.log
set -euo pipefail
shards=$1
results=$2
shift 2

mkdir -p "$results"
file=$results/$SLURM_ARRAY_TASK_ID.json
[[ ! -e $file ]] || exit 0
gloam check "$@" --shard "$SLURM_ARRAY_TASK_ID/$shards" --quiet --resume --json "$file" || [[ -e $file ]] # a result
