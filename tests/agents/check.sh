#!/usr/bin/env bash
# Uses a virtual arm as an agent does, with the protocol's own libraries for Python and TypeScript.
#
#   tests/agents/check.sh DOBOT     the program, built with the feature `full`
#
# The `python3` in the search path has the packages of tests/python/wide.txt, and `npm ci` has run in this folder.
set -euo pipefail

readonly DOBOT=$1
cd "$(dirname "${BASH_SOURCE[0]}")"

folder=$(mktemp -d)
export DOBOT DOBOT_DATA=$folder
"$DOBOT" up --virtual --time-factor 8 --http 127.0.0.1:0 --raw off --data "$folder" >"$folder/log" &
station=$!
trap 'kill "$station"; wait "$station" || true; rm -rf "$folder"' EXIT
for _ in {1..300}; do
  address=$(sed -n 's/^address = "\(.*\)"/\1/p' "$folder/station.toml" 2>/dev/null) || true
  [[ -n $address ]] && break
  sleep 0.1
done
[[ -n $address ]] || { cat "$folder/log" >&2; exit 1; }
python3 check.py "$address"
node check.mjs "$address"
