#!/usr/bin/env bash
# Builds everything that is distributed, from a clean clone, into target/products:
#
#   release/all.sh [TARGET]
#
# The archive, on Debian also the package, the wheel and the source distribution for Python, the crates, the list of parts
# (CycloneDX) and the checksums. `release/again.sh` builds all of it in another folder and compares.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

rm -rf "$PRODUCTS"
release/archive.sh "$TARGET"
if [[ $TARGET == x86_64-unknown-linux-gnu ]] && command -v dpkg-deb >/dev/null; then
  release/deb.sh "$TARGET"
fi
release/wheel.sh "$TARGET"
release/crates.sh
cd "$PRODUCTS"
tools=$(command -v sha256sum || echo shasum -a 256)
find . -type f ! -name SHA256SUMS | sed 's|^\./||' | sort | xargs $tools >SHA256SUMS
cat SHA256SUMS
