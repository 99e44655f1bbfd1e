#!/usr/bin/env bash
# Writes the arm as a model in every format and with every tool, and checks each with PyPI's yourdfpy and mujoco.
#
#   tests/models/check.sh PROGRAMS     the folder with the program `dobot` and the folder `examples`
#
# They are fetched into a virtual environment at the first run; Python 3 is enough.
set -euo pipefail

readonly PROGRAMS=$1
readonly PACKAGES=(yourdfpy==0.0.60 mujoco==4.0.0)
readonly VENV=${XDG_CACHE_HOME:-$HOME/.cache}/dobot/models-1

if [[ ! -e $VENV/installed ]]; then
  python3 -m venv "$VENV"
  "$VENV/bin/pip" install --quiet "${PACKAGES[@]}"
  touch "$VENV/installed"
fi
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for tool in none cup gripper pen laser; do
  "$PROGRAMS/dobot" model --format urdf --tool "$tool" -o "$folder/$tool.urdf"
  "$PROGRAMS/dobot" model --format mjcf --tool "$tool" -o "$folder/$tool.xml"
  "$PROGRAMS/dobot" model --format json --tool "$tool" -o "$folder/$tool.json"
  [[ $tool == none ]] || "$PROGRAMS/examples/poses" "$tool" >"$folder/$tool.csv"
done
"$VENV/bin/python" "$(dirname "${BASH_SOURCE[0]}")/check.py" "$folder"
