#!/usr/bin/env bash
# Builds the container image dobot:VERSION from the archive of release/archive.sh, and asks its virtual arm for a status:
#
#   release/image.sh [TARGET]
#
# Needs `docker` with a running daemon, or `buildah` (in a container with BUILDAH_ISOLATION=chroot). Without them it only checks
# that the Dockerfile names files of the archive.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

main() {
  local archive=dobot-$VERSION-$TARGET.tar.xz arguments container
  check "$PRODUCTS/$archive"
  arguments=(--build-arg "ARCHIVE=$archive" --file release/Dockerfile --tag "dobot:$VERSION" "$PRODUCTS")
  if docker info >/dev/null 2>&1; then
    docker build "${arguments[@]}"
    docker run --rm "dobot:$VERSION" simulate --help >/dev/null
    docker run --rm "dobot:$VERSION" move 220 0 30 --to virtual:
  elif command -v buildah >/dev/null; then
    buildah build "${arguments[@]}"
    container=$(buildah from "localhost/dobot:$VERSION")
    buildah run "$container" -- dobot move 220 0 30 --to virtual:
    buildah rm "$container" >/dev/null
  else
    echo "left out: an image needs docker with a running daemon, or buildah"
  fi
}

# Every file that is copied from the archive is in it.
check() {
  local file files
  files=$(tar -tJf "$1" | sed 's|^[^/]*/||')
  for file in $(sed -n 's|^COPY --from=archive \(.*\) [^ ]*$|\1|p' release/Dockerfile); do
    # shellcheck disable=SC2053 # the name may be a pattern
    while read -r found; do [[ $found != ${file#/dobot/} ]] || continue 2; done <<<"$files"
    echo "release/Dockerfile copies $file, which is not in $1" >&2
    exit 1
  done
}

main
