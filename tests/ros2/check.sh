#!/usr/bin/env bash
# Uses an arm over ROS 2 with PyPI's `cyclonedds`, an implementation of DDS that knows nothing of ours.
#
#   tests/ros2/check.sh PROGRAMS     the folder with the programs `dobot` and `dobot-ros2`
#
# It is fetched into a virtual environment at the first run; Python 3 is enough, and no ROS is needed.
set -euo pipefail

readonly VERSION=11.0.1
readonly FOLDER=${XDG_CACHE_HOME:-$HOME/.cache}/dobot/cyclonedds-$VERSION

if [[ ! -e $FOLDER/installed ]]; then
  python3 -m venv "$FOLDER"
  "$FOLDER/bin/pip" install --quiet "cyclonedds==$VERSION"
  touch "$FOLDER/installed"
fi
"$FOLDER/bin/python" "$(dirname "${BASH_SOURCE[0]}")/check.py" "$1"
