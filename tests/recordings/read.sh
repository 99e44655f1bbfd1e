#!/usr/bin/env bash
# Reads recordings with PyPI's `mcap`, a reader that knows nothing of ours, and counts their messages.
#
#   tests/recordings/read.sh FOLDER              each FILE.mcap beside a FILE.mcap.count
#   tests/recordings/read.sh FOLDER scene.py     the recording of tests/foxglove/look_on.sh: the arm, its target, its ink
#
# `mcap` is fetched into a virtual environment at the first run; Python 3 is enough.
set -euo pipefail

readonly VERSION=1.6.0
readonly FOLDER=${XDG_CACHE_HOME:-$HOME/.cache}/dobot/mcap-$VERSION

if [[ ! -e $FOLDER/installed ]]; then
  python3 -m venv "$FOLDER"
  "$FOLDER/bin/pip" install --quiet "mcap==$VERSION"
  touch "$FOLDER/installed"
fi
"$FOLDER/bin/python" "$(dirname "${BASH_SOURCE[0]}")/${2:-read.py}" "$1"
