# What the scripts of a release have in common; they source it with the target triple, or nothing for this machine.
#
# Builds are the same bit for bit wherever they are made: one date, no paths of this machine, one order of files. On Linux zig
# (from PyPI) compiles and links what is C, so that a program runs with glibc 2.28 (Debian 10) and all later ones.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
umask 022

HOST=$(rustc -vV | sed -n 's/^host: //p')
TARGET=${1:-$HOST}
VERSION=$(sed -n 's/^version = "\(.*\)"/\1/p' Cargo.toml)
BUILD=${CARGO_TARGET_DIR:-$PWD/target}
PRODUCTS=$PWD/target/products
STAGE=$BUILD/stage/dobot-$VERSION-$TARGET
PROGRAMS=$BUILD/$TARGET/dist
EXE=
[[ $TARGET != *windows* ]] || EXE=.exe
readonly HOST TARGET VERSION BUILD PRODUCTS STAGE PROGRAMS EXE
readonly GLIBC=2.28

SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct)}
export SOURCE_DATE_EPOCH LC_ALL=C TZ=UTC PYO3_BUILD_EXTENSION_MODULE=1

# Programs from PyPI, as pinned in tests/python/release.txt.
tools() {
  local venv=$BUILD/release-tools
  local bin=$venv/bin
  [[ $HOST != *windows* ]] || bin=$venv/Scripts
  if ! cmp -s tests/python/release.txt "$venv/release.txt"; then
    "$(command -v python3 || command -v python)" -m venv "$venv"
    "$bin/python" -m pip install --quiet --disable-pip-version-check --no-deps -r tests/python/release.txt
    cp tests/python/release.txt "$venv/release.txt"
  fi
  export PATH=$bin:$PATH
}

# Replaces the folders of this machine in what the compilers write. The last rule that fits counts.
trim_paths() {
  local cargo=${CARGO_HOME:-$HOME/.cargo} from flags=() c_flags=()
  for from in "$cargo=/cargo" "$PWD=/dobot" "$BUILD=/dobot/target"; do
    flags+=("--remap-path-prefix=$from")
    c_flags+=("-ffile-prefix-map=$from")
  done
  CARGO_ENCODED_RUSTFLAGS=$(IFS=$'\x1f' && echo "${flags[*]}")
  export CARGO_ENCODED_RUSTFLAGS
  [[ $TARGET == *msvc* ]] || export CFLAGS="${c_flags[*]}"
}

# Builds for the target: `compile build ARGUMENT...`.
compile() {
  trim_paths
  if [[ $TARGET == *linux-gnu* ]]; then
    cargo-zigbuild "zig$1" --locked --target "$TARGET.$GLIBC" "${@:2}"
  else
    cargo "$1" --locked --target "$TARGET" "${@:2}"
  fi
}

# Fails if a file is larger than docs/performance.md allows.
at_most() {
  local file=$1 limit=$2 bytes
  bytes=$(wc -c <"$file")
  if ((bytes > limit)); then
    echo "$file has $bytes bytes; allowed are $limit: what has become so large?" >&2
    exit 1
  fi
  printf '%10d bytes (of %d)  %s\n' "$bytes" "$limit" "${file##*/}"
}
