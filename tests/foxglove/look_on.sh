#!/usr/bin/env bash
# Looks on at a station with npm's `@foxglove/ws-protocol`, Foxglove's own client, which knows nothing of ours.
#
#   tests/foxglove/look_on.sh DOBOT [FOLDER]     the program, and where the station's recording is left
#
# The client is fetched at the first run; Node is enough.
set -euo pipefail

readonly VERSION=0.8.0
readonly FOLDER=${XDG_CACHE_HOME:-$HOME/.cache}/dobot/foxglove-$VERSION

if [[ ! -e $FOLDER/installed ]]; then
  mkdir -p "$FOLDER"
  npm install --silent --no-audit --no-fund --prefix "$FOLDER" "@foxglove/ws-protocol@$VERSION" ws
  touch "$FOLDER/installed"
fi
NODE_PATH=$FOLDER/node_modules node "$(dirname "${BASH_SOURCE[0]}")/look_on.cjs" "$@"
