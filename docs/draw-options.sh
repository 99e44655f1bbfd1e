#!/usr/bin/env bash
# Prints docs/draw-options.md: what `dobot draw --help` prints.
set -euo pipefail
cat <<'HEAD'
# Options of `dobot draw`

For everyone who draws or burns a file: every option with its unit and default, as `dobot draw --help` prints it. [Drawing](drawing.md)
explains how they work together.

```text
HEAD
"$1" draw --help
echo '```'
