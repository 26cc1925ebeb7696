#!/usr/bin/env bash
# Prints the status of Slurm job $1 for snakemake: running, success or failed.
set -uo pipefail
state=$(scontrol --oneliner show job "$1" 2>/dev/null | grep -o ' JobState=[A-Z_]*' | cut -d= -f2)
# Once scontrol has forgotten a job, the accounting database, if there is one, may still know it.
state=${state:-$(sacct -X -n -P -o State -j "$1" 2>/dev/null | head -n 1)}
case "$state" in
  COMPLETED) echo success ;;
  PENDING | RUNNING | CONFIGURING | COMPLETING | REQUEUED | SUSPENDED) echo running ;;
  *) echo failed ;;
esac
