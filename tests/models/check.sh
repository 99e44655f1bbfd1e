#!/usr/bin/env bash
# Writes the arm as a model in every format and with every tool, and checks each with programs of others.
#
#   tests/models/check.sh PROGRAMS     the folder with the program `dobot` and the folder `examples`
#
# The `python3` in the search path has the packages of tests/python/wide.txt.
set -euo pipefail

PROGRAMS=$(realpath "$1")
readonly PROGRAMS

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
for tool in none cup gripper pen laser; do
  "$PROGRAMS/dobot" model --format urdf --tool "$tool" -o "$folder/$tool.urdf"
  "$PROGRAMS/dobot" model --format mjcf --tool "$tool" -o "$folder/$tool.xml"
  "$PROGRAMS/dobot" model --format json --tool "$tool" -o "$folder/$tool.json"
  "$PROGRAMS/dobot" model --format moveit --tool "$tool" -o "$folder/$tool.moveit"
  [[ $tool == none ]] || "$PROGRAMS/examples/poses" "$tool" >"$folder/$tool.csv"
done
cd "$(dirname "${BASH_SOURCE[0]}")"
for check in check moveit dynamics; do
  python3 "$check.py" "$folder"
done
