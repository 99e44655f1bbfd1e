#!/usr/bin/env bash
# Installs a made-up release as the GitHub Action does: the program is there; a damaged archive and an unknown version are refused.
#
#   tests/workflows/install.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
name=dobot-1.2.3-$(uname -m)-unknown-linux-gnu
mkdir -p "$work/v1.2.3" "$work/$name"
printf '#!/bin/sh\necho it runs\n' >"$work/$name/dobot"
chmod +x "$work/$name/dobot"
tar -cJf "$work/v1.2.3/$name.tar.xz" -C "$work" "$name"
(cd "$work/v1.2.3" && sha256sum "$name.tar.xz" >SHA256SUMS)

release/install.sh 1.2.3 "$work/installed" "file://$work"
[[ $("$work/installed/dobot") == 'it runs' ]]

refuses() {
  local expected=$1 output
  if output=$(release/install.sh "${@:2}" "$work/none" "file://$work" 2>&1) || [[ $output != *"$expected"* || -e $work/none ]]; then
    echo "expected is a refusal with \`$expected\`; found: $output" >&2
    exit 1
  fi
}

refuses 'expected three numbers' main
refuses 'cannot load' 9.9.9
echo damage >>"$work/v1.2.3/$name.tar.xz"
refuses 'is not the file of SHA256SUMS' 1.2.3
echo "the action's installation: all passed"
