#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
# sbatch --array=0-199 slurm.sh LIST RESULTS 200: a task for each of 200 shards of a work list. A task whose node died
# is queued again. After the array has ended, the same with --array=$(gloam work missing LIST --results RESULTS
# --shards 200) runs what is missing, if anything.
#SBATCH --job-name=gloam --requeue --open-mode=append --output=gloam-%A_%a.log
exec gloam work run "$1" --results "$2" --shard "$SLURM_ARRAY_TASK_ID/$3"
