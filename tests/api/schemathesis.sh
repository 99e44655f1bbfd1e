#!/usr/bin/env bash
# Tries the API of a running station with requests that schemathesis makes from its OpenAPI document.
#
#   tests/api/schemathesis.sh [ADDRESS]     such as http://127.0.0.1:8642, which is the default
#
# Only for a station with a virtual arm: it may move. schemathesis is fetched into a virtual environment
# at the first run; Python 3 is enough. EXAMPLES=1000 makes it thorough.
set -euo pipefail

readonly ADDRESS=${1:-http://127.0.0.1:8642}
readonly VERSION=4.32.5
CONFIG=$(realpath "$(dirname "$0")/schemathesis.toml")
readonly CONFIG
readonly FOLDER=${XDG_CACHE_HOME:-$HOME/.cache}/dobot/schemathesis-$VERSION

if [[ ! -x $FOLDER/bin/schemathesis ]]; then
  python3 -m venv "$FOLDER"
  "$FOLDER/bin/pip" install --quiet "schemathesis==$VERSION"
fi

# It keeps what it found beside itself: not in this project.
mkdir -p "$FOLDER/work"
cd "$FOLDER/work"

# What the document allows may still be refused by lease, policy or link: that is not checked. The
# WebSocket has tests of its own.
"$FOLDER/bin/schemathesis" --config-file "$CONFIG" run "$ADDRESS/api/v1/openapi.json" \
  --url "$ADDRESS" \
  --checks not_a_server_error,status_code_conformance,content_type_conformance,response_schema_conformance,response_headers_conformance,negative_data_rejection,unsupported_method \
  --exclude-path /api/v1/ws \
  --max-examples "${EXAMPLES:-50}" \
  --request-timeout 10 \
  --generation-database none \
  --no-color
