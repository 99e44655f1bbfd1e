#!/usr/bin/env bash
# Tries the API of a running station with requests that schemathesis makes from its OpenAPI document.
#
#   tests/api/schemathesis.sh [ADDRESS]     such as http://127.0.0.1:8642, which is the default
#
# Only for a station with a virtual arm: it may move. SCHEMATHESIS names the program, of the version in tests/python/ci.txt.
# EXAMPLES=1000 makes it thorough.
set -euo pipefail

readonly ADDRESS=${1:-http://127.0.0.1:8642}
CONFIG=$(realpath "$(dirname "$0")/schemathesis.toml")
readonly CONFIG
readonly SCHEMATHESIS=${SCHEMATHESIS:-schemathesis}

# It keeps its findings in the current folder.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# What the document allows may still be refused by lease, policy or link: that is not checked. The
# WebSocket has tests of its own.
"$SCHEMATHESIS" --config-file "$CONFIG" run "$ADDRESS/api/v1/openapi.json" \
  --url "$ADDRESS" \
  --checks not_a_server_error,status_code_conformance,content_type_conformance,response_schema_conformance,response_headers_conformance,negative_data_rejection,unsupported_method \
  --exclude-path /api/v1/ws \
  --max-examples "${EXAMPLES:-50}" \
  --request-timeout 10 \
  --generation-database none \
  --no-color
