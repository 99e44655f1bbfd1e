#!/usr/bin/env bash
# A class with its board: three stations, each in a network of its own with a browser, and a router between them that is killed.
#
#   board.sh PROGRAM CHROMIUM
#
# PROGRAM is a `dobot` with the feature `fleet`. `page/tests/class.mjs` says what happens; it needs Node and the packages of
# `page/`.
set -euo pipefail
export DOBOT=$1 CHROMIUM=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/networks.sh"

make_networks "$DOBOT"
node --test "$here/../../page/tests/class.mjs"
