#!/usr/bin/env bash
# Exports a recording in every form, and reads what comes out with PyPI's pandas, pyarrow and datasets.
#
#   tests/recordings/tables.sh PROGRAM FOLDER     the program `dobot`; the folder holds one recording
#
# They are fetched into a virtual environment at the first run; Python 3 is enough.
set -euo pipefail

readonly PROGRAM=$1 FOLDER=$2
readonly PACKAGES=(mcap==1.6.0 datasets==5.2.0 pandas==3.1.1 pyarrow==26.0.1)
readonly VENV=${XDG_CACHE_HOME:-$HOME/.cache}/dobot/tables-1

if [[ ! -e $VENV/installed ]]; then
  python3 -m venv "$VENV"
  "$VENV/bin/pip" install --quiet "${PACKAGES[@]}"
  touch "$VENV/installed"
fi
for form in csv parquet; do
  "$PROGRAM" log "$FOLDER"/*.mcap --export "$form" -o "$FOLDER/run.$form"
done
"$PROGRAM" log "$FOLDER"/*.mcap --export lerobot --task "Turn." -o "$FOLDER/dataset"
# It keeps its cache in the folder too, and asks nobody on the network.
HF_HOME=$FOLDER/cache HF_HUB_OFFLINE=1 "$VENV/bin/python" "$(dirname "${BASH_SOURCE[0]}")/tables.py" "$FOLDER"
