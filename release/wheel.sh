#!/usr/bin/env bash
# Builds the wheel of the Python package, and on Linux its source distribution, after release/archive.sh:
#
#   release/wheel.sh [TARGET]
#
# The wheel contains the program `dobot`, which guards an arm at a serial port. The module uses what the archive's build has
# compiled, and is linked so that it becomes small.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"
tools

main() {
  local scripts=python/dobot_arm._core.data/scripts wheel
  trap 'rm -rf python/dobot_arm._core.data python/LICENSES-OF-OTHERS.txt' EXIT
  mkdir -p "$PRODUCTS"
  cp "$STAGE/LICENSES-OF-OTHERS.txt" python
  trim_paths
  if [[ $TARGET == x86_64-unknown-linux-gnu ]]; then
    (cd python && maturin sdist --out "$PRODUCTS")
  fi
  mkdir -p "$scripts"
  cp "$PROGRAMS/dobot$EXE" "$scripts"
  module
  for wheel in "$PRODUCTS"/*.whl; do
    python - "$wheel" <<<"$CHECK"
    python - "$wheel" "$BUILD/stage/module" <<<"$SIZE_WITHOUT_PROGRAM"
    at_most "$BUILD/stage/module" 8000000
    at_most "$wheel" 33000000
  done
}

module() {
  local -a for_linux=()
  if [[ $TARGET == *linux-gnu* ]]; then
    for_linux=(--compatibility "manylinux_${GLIBC/./_}")
    export GLIBC CARGO=$PWD/release/cargo-zig.sh
  fi
  (cd python && maturin build --profile dist --locked --target "$TARGET" --out "$PRODUCTS" \
    --compression-level 9 --sbom-include "$STAGE/parts.cdx.json" ${for_linux[@]+"${for_linux[@]}"} -- -C lto=fat)
}

# The wheel contains our licences and those of what is linked, and what an index shows of it.
readonly CHECK='
import sys, zipfile
from email import message_from_bytes
wheel = zipfile.ZipFile(sys.argv[1])
sizes = {file.filename: file.file_size for file in wheel.infolist()}
for name, least in ("LICENSE-MIT", 500), ("LICENSE-APACHE", 5000), ("LICENSES-OF-OTHERS.txt", 50_000):
    if not any(path.endswith(f".dist-info/licenses/{name}") and size >= least for path, size in sizes.items()):
        sys.exit(f"{sys.argv[1]} lacks {name}")
about = message_from_bytes(wheel.read(next(path for path in sizes if path.endswith(".dist-info/METADATA"))))
for field in "Summary", "License-Expression", "Author", "Project-URL", "Classifier", "Description-Content-Type":
    if not about[field]:
        sys.exit(f"{sys.argv[1]} lacks {field} in its metadata")
if len(about.get_payload()) < 500:
    sys.exit(f"{sys.argv[1]} lacks a description")
'

# A file as large as the wheel is without the program.
readonly SIZE_WITHOUT_PROGRAM='
import sys, zipfile
files = zipfile.ZipFile(sys.argv[1]).infolist()
size = sum(file.compress_size for file in files if ".data/scripts/" not in file.filename)
with open(sys.argv[2], "wb") as out:
    out.truncate(size)
'

main
