#!/usr/bin/env bash
# Tells snakemake how the Slurm job $1 fares: running, success or failed.
set -uo pipefail
state=$(scontrol --oneliner show job "$1" 2>/dev/null | grep -o ' JobState=[A-Z_]*' | cut -d= -f2)
# What scontrol has forgotten, the accounting may know, if the cluster has one.
state=${state:-$(sacct -X -n -P -o State -j "$1" 2>/dev/null | head -n 1)}
case "$state" in
  COMPLETED) echo success ;;
  PENDING | RUNNING | CONFIGURING | COMPLETING | REQUEUED | SUSPENDED) echo running ;;
  *) echo failed ;;
esac
