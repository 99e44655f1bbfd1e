#!/usr/bin/env bash
# Uses the products of release/all.sh as somebody who has nothing else of this project:
#
#   release/trial.sh debian bookworm    installs, starts, draws, teaches, stops and removes, in a new Debian
#   release/trial.sh wheel              the wheel with each Python from 3.10 to 3.13 that is here
#   release/trial.sh crates             a program of another project that uses the packed crates
#   release/trial.sh                    all of it, in Debian 11, 12 and 13
#
# The Debian is made by debootstrap, as root; it has a network of its own. Without root or debootstrap this part is left out.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

main() {
  local suite
  case ${1:-all} in
    debian) debian "$2" ;;
    wheel) wheel ;;
    crates) crates ;;
    all)
      for suite in bullseye bookworm trixie; do
        debian "$suite"
      done
      wheel
      crates
      ;;
    *) fail "\`$1\` is not debian, wheel or crates" ;;
  esac
}

debian() {
  local suite=$1 base=$BUILD/roots/$1 package
  package=$(ls "$PRODUCTS"/dobot_*_amd64.deb)
  if [[ $EUID != 0 ]] || ! command -v debootstrap unshare >/dev/null; then
    echo "left out: the trial in $suite needs root, and debootstrap (Debian package debootstrap)"
    return
  fi
  if [[ ! -e $base.done ]]; then
    rm -rf "$base"
    mkdir -p "$base"
    debootstrap --variant=minbase "$suite" "$base" "${MIRROR:-http://deb.debian.org/debian}" >"$base.log"
    touch "$base.done"
  fi
  ROOT=$(mktemp -d)
  trap 'rm -rf "$ROOT"' EXIT
  cp -a "$base/." "$ROOT"
  cp "$package" "$ROOT/dobot.deb"
  chroot "$ROOT" useradd --create-home pupil
  echo "== $suite"
  unshare --mount --net --pid --fork --kill-child release/trial/debian.sh "$ROOT"
  rm -rf "$ROOT"
  trap - EXIT
}

wheel() {
  local python version tried='' folder
  for python in python3.{10,11,12,13} "$HOME"/.pyenv/versions/3.1[0-3].*/bin/python; do
    version=$("$python" -c 'import ensurepip, sys; print(sys.version_info[:2])' 2>/dev/null) || continue
    [[ $tried != *"$version"* ]] || continue
    folder=$(mktemp -d)
    "$python" -m venv "$folder/venv"
    "$folder/venv/bin/pip" install --quiet --no-index --disable-pip-version-check "$PRODUCTS"/dobot_arm-*.whl
    # Neither this project nor another `dobot` is in reach.
    (cd "$folder" && env -i HOME="$folder" PATH=/usr/bin:/bin venv/bin/python -I -) <release/trial/wheel.py
    rm -rf "$folder"
    tried+=$version
  done
  [[ -n $tried ]] || fail "there is no Python from 3.10 to 3.13 with venv"
}

crates() {
  local folder crate name
  folder=$BUILD/outside
  rm -rf "$folder"
  mkdir -p "$folder/src"
  cp release/trial/crates.rs "$folder/src/main.rs"
  {
    printf '[package]\nname = "outside"\nversion = "0.0.0"\nedition = "2024"\n[workspace]\n[dependencies]\n'
    printf '%s = "%s"\n' dobot-arm "$VERSION" dobot-controller "$VERSION" dobot-sim "$VERSION" dobot-wire "$VERSION"
    printf 'dobot-session = { version = "%s", features = ["io"] }\n' "$VERSION"
    printf 'tokio = { version = "1", features = ["macros", "rt-multi-thread"] }\n[patch.crates-io]\n'
    for crate in "$PRODUCTS"/crates/*.crate; do
      # With the current time: all files in a package have the same date, and a changed one would look unchanged.
      tar -xmzf "$crate" -C "$folder"
      name=$(basename "$crate" .crate)
      printf '%s = { path = "%s" }\n' "${name%-"$VERSION"}" "$name"
    done
  } >"$folder/Cargo.toml"
  cp Cargo.lock "$folder"
  cargo run --quiet --manifest-path "$folder/Cargo.toml" --target-dir "$BUILD"
}

fail() {
  echo "error: $1" >&2
  exit 1
}

main "$@"
