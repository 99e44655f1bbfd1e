#!/usr/bin/env bash
# Builds a wheel of the Python package, by hand or in .github/workflows/release.yml:
#
#   release/wheel.sh                              for the system that this runs on
#   release/wheel.sh aarch64-unknown-linux-gnu    for another one
#
# It comes into target/wheels, with its SHA-256. On Linux zig (from PyPI) compiles and links what is C, so that a wheel runs
# with glibc 2.28 and all later ones, whatever the machine has that builds it; macOS needs nothing, and Windows
# neither.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

main() {
  local host target wheels venv python
  host=$(rustc -vV | sed -n 's/^host: //p')
  target=${1:-$host}
  wheels=$PWD/target/wheels
  venv=$(mktemp -d)
  mkdir -p "$wheels"
  trap 'rm -rf "$venv"' EXIT

  "$(command -v python3 || command -v python)" -m venv "$venv"
  python=$venv/bin/python
  [[ $host != *windows* ]] || python=$venv/Scripts/python.exe
  "$python" -m pip install --quiet 'maturin>=1.8,<2'
  # Its programs are looked for in the search path.
  PATH=$(dirname "$python"):$PATH
  local -a for_linux=()
  if [[ $target == *linux-gnu* ]]; then
    "$python" -m pip install --quiet ziglang
    for_linux=(--zig --compatibility manylinux_2_28)
  fi
  (cd python && maturin build --profile wheel --locked --target "$target" --out "$wheels" ${for_linux[@]+"${for_linux[@]}"})
  for wheel in "$wheels"/*.whl; do
    check "$wheel"
  done
}

check() {
  local wheel=$1 bytes
  bytes=$(wc -c <"$wheel")
  if ((bytes > MOST_BYTES)); then
    echo "$wheel has $bytes bytes; allowed are $MOST_BYTES: what has become so large?" >&2
    exit 1
  fi
  (
    cd "$(dirname "$wheel")"
    wheel=$(basename "$wheel")
    if command -v sha256sum >/dev/null; then
      sha256sum "$wheel"
    else
      shasum -a 256 "$wheel"
    fi >"$wheel.sha256"
    cat "$wheel.sha256"
  )
}

# What docs/performance.md promises.
readonly MOST_BYTES=8000000

main "$@"
