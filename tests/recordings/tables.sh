#!/usr/bin/env bash
# Exports a recording in every form, and reads what comes out with PyPI's pandas, pyarrow and datasets.
#
#   tests/recordings/tables.sh PROGRAM FOLDER     the program `dobot`; the folder holds one recording
#
# The `python3` in the search path has the packages of tests/python/wide.txt.
set -euo pipefail

readonly PROGRAM=$1 FOLDER=$2

for form in csv parquet; do
  "$PROGRAM" log "$FOLDER"/*.mcap --export "$form" -o "$FOLDER/run.$form"
done
"$PROGRAM" log "$FOLDER"/*.mcap --export lerobot --task "Turn." -o "$FOLDER/dataset"
# It keeps its cache in the folder too, and asks nobody on the network.
HF_HOME=$FOLDER/cache HF_HUB_OFFLINE=1 python3 "$(dirname "${BASH_SOURCE[0]}")/tables.py" "$FOLDER"
