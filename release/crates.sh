#!/usr/bin/env bash
# Packs the crates that are published, into target/products/crates, and prints the order in which they depend on each other:
#
#   release/crates.sh
#
# `cargo publish` with the same names uploads them.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

main() {
  local names name
  local -a packages=()
  names=$(published)
  for name in $names; do
    packages+=(-p "$name")
  done
  rm -f "$BUILD"/package/dobot-*.crate
  cargo package --quiet --locked --no-verify --allow-dirty --exclude-lockfile "${packages[@]}"
  rm -rf "$PRODUCTS/crates"
  mkdir -p "$PRODUCTS/crates"
  cp "$BUILD"/package/dobot-*.crate "$PRODUCTS/crates"
  echo "crates, each after those that it needs:" $names
}

# The crates without `publish = false`, each after those that it needs.
published() {
  cargo metadata --locked --no-deps --format-version 1 | "$(command -v python3 || command -v python)" -c '
import graphlib, json, sys
packages = {package["name"]: package for package in json.load(sys.stdin)["packages"] if package["publish"] is None}
needs = {name: [need["name"] for need in package["dependencies"] if need.get("path") and need["kind"] != "dev"]
         for name, package in packages.items()}
for name in graphlib.TopologicalSorter(needs).static_order():
    if name not in packages:
        sys.exit(f"{name} is needed by a published crate; publish it, too")
    print(name)
'
}

main
