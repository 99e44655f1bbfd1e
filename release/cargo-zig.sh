#!/usr/bin/env bash
# The `cargo` of maturin on Linux: compiles as `compile` in release/settings.sh does, so that the Python module uses what the
# archive's build has compiled. maturin's own `--zig` names another linker, for which cargo would compile all of it again.
set -euo pipefail
unset CARGO
arguments=("$@")
if [[ $1 == rustc ]]; then
  for at in "${!arguments[@]}"; do
    [[ ${arguments[at]} != *-linux-gnu ]] || arguments[at]+=.$GLIBC
  done
  exec cargo-zigbuild "${arguments[@]}"
fi
exec cargo "$@"
