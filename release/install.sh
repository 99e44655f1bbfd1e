#!/usr/bin/env bash
# Installs the program of a release for this machine into a new folder:
#
#   release/install.sh VERSION FOLDER ADDRESS
#
# ADDRESS/vVERSION has the archives and SHA256SUMS. An archive with another sum is not unpacked. action.yml uses this.
set -euo pipefail

fail() {
  echo "$*" >&2
  exit 1
}

target() {
  case $(uname -s)-$(uname -m) in
    Linux-x86_64) echo x86_64-unknown-linux-gnu ;;
    Linux-aarch64) echo aarch64-unknown-linux-gnu ;;
    Darwin-arm64) echo aarch64-apple-darwin ;;
    Darwin-x86_64) echo x86_64-apple-darwin ;;
    MINGW*-x86_64 | MSYS*-x86_64) echo x86_64-pc-windows-msvc ;;
    *) fail "there is no program for $(uname -s) on $(uname -m); build it from source" ;;
  esac
}

main() {
  local version=$1 folder=$2 address=$3/v$1 name archive
  [[ $version =~ ^[0-9]+\.[0-9]+\.[0-9]+$ ]] || fail "the version is \`$version\`; expected three numbers, as in 0.1.0"
  name=dobot-$version-$(target)
  archive=$name.tar.xz
  [[ $name != *windows* ]] || archive=$name.zip
  sums=$(mktemp -d)
  trap 'rm -rf "$sums"' EXIT # not local: it runs at the very end
  curl -fsSL --retry 3 -o "$sums/$archive" "$address/$archive" || fail "cannot load $address/$archive"
  curl -fsSL --retry 3 -o "$sums/SHA256SUMS" "$address/SHA256SUMS" || fail "cannot load $address/SHA256SUMS"
  (cd "$sums" && grep -F " $archive" SHA256SUMS | check) || fail "$archive is not the file of SHA256SUMS"
  mkdir "$folder"
  case $archive in
    *.zip) unzip -q "$sums/$archive" -d "$sums" && mv "$sums/$name"/* "$folder" ;;
    *) tar -xJf "$sums/$archive" -C "$folder" --strip-components 1 ;;
  esac
}

check() {
  if command -v sha256sum >/dev/null; then sha256sum --check --status; else shasum -a 256 --check --status; fi
}

[[ $# == 3 ]] || fail "usage: release/install.sh VERSION FOLDER ADDRESS"
main "$@"
