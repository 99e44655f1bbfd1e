#!/usr/bin/env bash
# Reads recordings with PyPI's `mcap`, a reader that knows nothing of ours, and counts their messages.
#
#   tests/recordings/read.sh FOLDER              each FILE.mcap beside a FILE.mcap.count
#   tests/recordings/read.sh FOLDER scene.py     the recording of tests/foxglove/look_on.sh: the arm, its target, its ink
#
# The `python3` in the search path has the packages of tests/python/wide.txt.
set -euo pipefail

python3 "$(dirname "${BASH_SOURCE[0]}")/${2:-read.py}" "$1"
