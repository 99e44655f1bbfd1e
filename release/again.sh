#!/usr/bin/env bash
# Builds everything a second time, from a clone of the last commit in another folder, and compares the checksums with those of
# release/all.sh:
#
#   release/again.sh
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
git clone --quiet . "$folder/dobot"
(cd "$folder/dobot" && env -u CARGO_TARGET_DIR release/all.sh "$TARGET" >/dev/null)
diff {"$PRODUCTS","$folder/dobot/target/products"}/"SHA256SUMS-$TARGET"
echo "both builds are the same bit for bit"
