#!/usr/bin/env bash
# Builds the archive of a release for the system that this runs on, by hand or in .github/workflows/release.yml:
#
#   release/archive.sh          makes target/archives/dobot-VERSION-HOST.tar.gz (.zip on Windows) and its SHA-256
#
# In it: the program, its man pages and completions, README, changelog, licences, and those of all that is linked.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

main() {
  local host version name archives folder
  host=$(rustc -vV | sed -n 's/^host: //p')
  version=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
  name=dobot-$version-$host
  archives=target/archives
  folder=$archives/$name
  rm -rf "$folder"
  mkdir -p "$folder"

  cargo build --locked --profile dist -p dobot-cli --features full
  fill "$folder" "$host"
  (cd "$archives" && pack "$name" "$host")
}

fill() {
  local folder=$1 host=$2 program shell
  program=${CARGO_TARGET_DIR:-target}/dist/dobot
  [[ $host != *windows* ]] || program+=.exe
  cp "$program" README.md CHANGELOG.md SECURITY.md LICENSE LICENSE-MIT LICENSE-APACHE "$folder"
  mkdir -p "$folder/man" "$folder/completions"
  "$program" man --out "$folder/man"
  for shell in bash zsh fish powershell; do
    "$program" completions "$shell" >"$folder/completions/dobot.$shell"
  done
  linked_licences "$host" >"$folder/LICENSES-OF-OTHERS.txt"
}

# Each package that is linked, with its licence and what its authors want to be handed on.
linked_licences() {
  local host=$1 sources package version licence file
  sources=${CARGO_HOME:-$HOME/.cargo}/registry/src
  cargo tree --locked -p dobot-cli --features full --edges normal --target "$host" --prefix none --format '{p}|{l}' |
    sed 's/ (\*)$//; s/ (proc-macro)//' | grep -v '^dobot-' | sort -u |
    while IFS='|' read -r package licence; do
      version=${package#* v}
      package=${package%% *}
      printf '==== %s %s: %s\n\n' "$package" "$version" "$licence"
      for file in "$sources"/*/"$package-$version"/{LICEN[CS]E,COPYING,NOTICE,UNLICENSE,license}*; do
        [[ ! -f $file ]] || { cat "$file" && echo; }
      done
    done
}

pack() {
  local name=$1 host=$2 file
  if [[ $host == *windows* ]]; then
    file=$name.zip
    rm -f "$file"
    7z a -bso0 "$file" "$name"
  else
    file=$name.tar.gz
    tar -czf "$file" "$name"
  fi
  rm -rf "$name"
  if command -v sha256sum >/dev/null; then
    sha256sum "$file"
  else
    shasum -a 256 "$file"
  fi >"$file.sha256"
  cat "$file.sha256"
}

main
