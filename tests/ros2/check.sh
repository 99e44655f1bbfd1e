#!/usr/bin/env bash
# Uses an arm over ROS 2 with PyPI's `cyclonedds`, an implementation of DDS that knows nothing of ours.
#
#   tests/ros2/check.sh PROGRAMS     the folder with the programs `dobot` and `dobot-ros2`
#
# The `python3` in the search path has the packages of tests/python/wide.txt.
set -euo pipefail

python3 "$(dirname "${BASH_SOURCE[0]}")/check.py" "$1"
