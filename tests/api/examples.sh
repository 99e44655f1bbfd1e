#!/usr/bin/env bash
# Runs the examples of docs/api.md at a station, in their order.
#
#   tests/api/examples.sh [ADDRESS]     such as http://127.0.0.1:8642, which is the default
#
# Only for a station with a virtual arm: it moves. Needs curl, Python 3 and Node.
set -euo pipefail

readonly ADDRESS=${1:-http://127.0.0.1:8642}
readonly DOCUMENT=$(dirname "$0")/../../docs/api.md
folder=$(mktemp -d)
readonly folder
trap 'rm -rf "$folder"' EXIT

# Each fenced block becomes a file: 01.sh, 02.python, ...
awk -v folder="$folder" '
  /^```(sh|python|js)$/ { number += 1; file = sprintf("%s/%02d.%s", folder, number, substr($0, 4)); next }
  /^```/ { file = ""; next }
  file != "" { print > file }
' "$DOCUMENT"

for example in "$folder"/*; do
  sed -i "s|http://127.0.0.1:8642|$ADDRESS|g; s|ws://127.0.0.1:8642|ws://${ADDRESS#http://}|g" "$example"
  echo "== ${example##*/}"
  case $example in
    *.sh) bash -e "$example" </dev/null ;;
    *.python) python3 "$example" </dev/null ;;
    *.js) node --experimental-websocket --input-type=module <"$example" ;;
  esac >"$folder/output" 2>&1 || { cat "$folder/output" "$example"; exit 1; }
done
