#!/usr/bin/env bash
# Builds the programs and their archive, target/products/dobot-VERSION-TARGET.tar.xz (.zip for Windows):
#
#   release/archive.sh [TARGET]
#
# In it: the programs, man pages, completions, the udev rule, README, changelog, licences, those of all that is linked, and the
# list of parts. The folder of the archive remains, for release/deb.sh and release/wheel.sh.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"
tools

main() {
  compile build --profile dist -p dobot-cli -p dobot-ros2 --features dobot-cli/fleet
  rm -rf "$STAGE"
  mkdir -p "$STAGE/man" "$STAGE/completions" "$PRODUCTS"
  cp "$PROGRAMS/dobot$EXE" "$PROGRAMS/dobot-ros2$EXE" "$STAGE"
  cp README.md CHANGELOG.md SECURITY.md LICENSE LICENSE-MIT LICENSE-APACHE "$STAGE"
  [[ $TARGET != *linux* ]] || cp release/60-dobot.rules "$STAGE"
  # Another machine's programs may not run here.
  if "$STAGE/dobot$EXE" --version >/dev/null 2>&1; then
    describe
  fi
  python release/parts.py "$TARGET" "$STAGE"
  local archive=$PRODUCTS/${STAGE##*/}.tar.xz
  [[ -z $EXE ]] || archive=${archive%.tar.xz}.zip
  python release/pack.py "$STAGE" "$archive"
  cp "$STAGE/parts.cdx.json" "$PRODUCTS/${STAGE##*/}.cdx.json"
  at_most "$archive" 25000000
}

describe() {
  local shell
  "$STAGE/dobot$EXE" man --out "$STAGE/man"
  for shell in bash zsh fish powershell; do
    "$STAGE/dobot$EXE" completions "$shell" >"$STAGE/completions/dobot.$shell"
  done
}

main
