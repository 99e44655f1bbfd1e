#!/usr/bin/env bash
# Builds everything that is distributed, from a clean clone, into target/products:
#
#   release/all.sh [TARGET]
#
# The archive, the wheel, the list of parts (CycloneDX) and SHA256SUMS-TARGET; on x86-64 Linux also the Debian package, the source
# distribution for Python and the crates. `release/again.sh` builds all of it in another folder and compares.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

rm -rf "$PRODUCTS"
release/archive.sh "$TARGET"
if [[ $TARGET == x86_64-unknown-linux-gnu ]] && command -v dpkg-deb >/dev/null; then
  release/deb.sh "$TARGET"
fi
release/wheel.sh "$TARGET"
if [[ $TARGET == x86_64-unknown-linux-gnu ]]; then
  release/crates.sh
fi
cd "$PRODUCTS"
digest=$(command -v sha256sum || echo shasum -a 256)
find . -type f | sed 's|^\./||' | sort | xargs $digest >"$BUILD/SHA256SUMS"
mv "$BUILD/SHA256SUMS" "SHA256SUMS-$TARGET"
cat "SHA256SUMS-$TARGET"
