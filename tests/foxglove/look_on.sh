#!/usr/bin/env bash
# Looks on at a station with npm's `@foxglove/ws-protocol`, Foxglove's own client, which knows nothing of ours.
#
#   tests/foxglove/look_on.sh DOBOT [FOLDER]     the program, and where the station's recording is left
#
# The client is one of the packages of `page/`: npm ci --prefix page.
set -euo pipefail

NODE_PATH=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../../page/node_modules") node "$(dirname "${BASH_SOURCE[0]}")/look_on.cjs" "$@"
