#!/usr/bin/env bash
# Every check of this project: what CI runs is what anyone can run.
#
#   ./ci.sh              all of CI's steps, in order
#   ./ci.sh STEP...      some steps
#   ./ci.sh help         the steps, a line each
#
# Set-up: Rust and git are enough, and a C++ compiler for `fuzz`, Python for `api`, `models`, `recordings`, `fleet` and `python`, Node and Chromium for
# `page` and `fleet`, which are installed on Debian if they are missing. Cargo fetches the dependencies at the first run.
#
# Why these steps:
#
# - Everything up to `bench-check` builds with the profile `dev` only, whose property tests are
#   optimised enough (Cargo.toml), so that nothing big is built twice. `no-std` is the exception: it
#   links only with `panic = "abort"` and link-time optimisation, and it is small.
# - `lint` also refuses what came into the standard library after a crate's `rust-version` (clippy's
#   `incompatible_msrv`); for the syntax it would need a second toolchain: `cargo +1.88 check`.
# - `test` is plain `cargo test`: other test runners have to be installed first.
# - `examples` runs the very command in the first line of each example, so that none grows old.
# - `bench-check` runs every benchmark once, unoptimised: does it still work? Numbers come from
#   `bench`, which is not part of CI: they want a calm machine (docs/performance.md).
# - `fuzz` is a smoke run, on the stable toolchain, with the same inputs each time; `fuzz-long 28800` makes a night of
#   it. What they find stays in `target/fuzz/found`, and becomes a seed in `fuzz/seeds`, which `cargo test` tries.
# - `api` fetches schemathesis from PyPI; a station with a virtual arm answers some thousand requests that
#   follow its OpenAPI document, and more that break it.
# - `page` makes the types of the API's messages anew and compares them with those checked in, checks the page's
#   files against them, and only then starts a browser; TypeScript comes from npm and writes nothing.
# - `models` fetches yourdfpy and mujoco from PyPI, programs that load models of robots and know nothing of ours, and
#   lets them calculate a thousand places with each tool.
# - `recordings` fetches `mcap` from PyPI, a reader of MCAP files that is not ours, and lets it read recordings
#   that were repaired; pandas, pyarrow and datasets read what was exported, and Foxglove's own client from npm what a
#   station tells live.
# - `fleet` gives each of three stations a network of its own, as root or where the system lets a user have some; a peer in
#   Python reads their states and stops one, and a class uses the board, in browsers in two of the networks.
# - `ros2` fetches `cyclonedds` from PyPI, an implementation of DDS that is not ours, and lets a program in Python use a
#   virtual arm through `dobot-ros2` and a station, on the loopback.
# - `package` packs every crate as `cargo publish` does, unpacks all of them into one workspace and checks
#   that: a file that is missing in a package is missing there. `cargo publish --dry-run --workspace` builds
#   each crate anew with all that it depends on; it is for the day of a release.
# - `licences` looks at every dependency on every platform with `cargo tree` alone.
#
# Why not others:
#
# - Other targets: they would have to be installed. What is Unix-only sits behind a `cfg`; that no
#   `std` slips into the lower rooms is proved by linking (`no-std`) on the host.
# - Advisories: they come from the network and change without a commit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
# What is compiled once and thrown away need not be compiled bit by bit.
[[ -z ${CI:-} ]] || export CARGO_INCREMENTAL=0

# name, what it does; in the order in which CI runs them, cheap ones first
readonly CI_STEPS=(
  "fmt          is all code formatted?"
  "licences     does every dependency have a licence that we may ship?"
  "lint         clippy over everything, warnings are errors; do the sources keep to the Rust version that each crate names?"
  "test         all tests, those in the documentation included"
  "doc          the documentation, warnings are errors; do the READMEs show its examples?"
  "package      does every crate build from its package?"
  "no-std       do wire, arm, motion, trajectory and controller link without the standard library?"
  "examples     run every example; none needs an arm"
  "api          try a station's API with requests made from its own document"
  "models       do PyPI's yourdfpy and mujoco bring the tool to where our kinematics do?"
  "recordings   do PyPI's mcap, pandas and datasets, and Foxglove's client, read what is recorded?"
  "fleet        a class in three networks: stations, a router that is killed, PyPI's eclipse-zenoh as a peer, and the board in a browser"
  "ros2         does PyPI's cyclonedds use the arm over ROS 2: states, targets, jogs, trajectories, a stop?"
  "python       does the Python package build, install, and do what its tests and types say?"
  "page         types, unit tests, and the page with a real pointer in a real browser"
  "bench-check  run every benchmark once, unoptimised"
  "fuzz         each fuzz target with a fixed number of inputs, as many targets at once as there are cores"
)
readonly OTHER_STEPS=(
  "bench          all benchmarks (not part of CI; see docs/performance.md)"
  "fuzz-long      each fuzz target with other inputs each time: fuzz-long SECONDS, or until it is interrupted"
  "compare-vpype  pen-up travel beside vpype's and LKH's (fetched from PyPI; takes an hour)"
  "compare-toppra arm time beside the time-optimal motion of toppra (fetched from PyPI)"
)

# The licences that dependencies come with; each allows what MIT and Apache 2.0 do, except MPL 2.0,
# whose files, unchanged here, keep it.
readonly LICENCES='(Apache-2.0 OR MIT) AND BSD-3-Clause
(MIT OR Apache-2.0) AND Unicode-3.0
0BSD OR MIT OR Apache-2.0
Apache-2.0
Apache-2.0 / MIT
Apache-2.0 AND ISC
Apache-2.0 OR BSL-1.0
Apache-2.0 OR ISC OR MIT
Apache-2.0 OR MIT
Apache-2.0 WITH LLVM-exception
Apache-2.0 WITH LLVM-exception OR Apache-2.0 OR MIT
Apache-2.0/MIT
BSD-2-Clause
BSD-2-Clause OR Apache-2.0 OR MIT
BSD-2-Clause OR MIT OR Apache-2.0
BSD-3-Clause
BSD-3-Clause OR Apache-2.0
CC0-1.0
CDLA-Permissive-2.0
EPL-2.0 OR Apache-2.0
ISC
MIT
MIT / Apache-2.0
MIT AND BSD-3-Clause
MIT OR Apache-2.0
MIT OR Apache-2.0 OR LGPL-2.1-or-later
MIT OR Apache-2.0 OR Zlib
MIT OR GPL-3.0-only
MIT OR Zlib OR Apache-2.0
MIT/Apache-2.0
MPL-2.0
Unlicense OR MIT
Unlicense/MIT
Zlib
Zlib OR Apache-2.0 OR MIT'

step_fmt() {
  needs_component fmt rustfmt
  cargo fmt --all --check
  cargo fmt --manifest-path tests/no-std/Cargo.toml --check
}

step_licences() {
  local found licence package unknown=
  found=$(dependencies)
  while IFS='|' read -r licence package; do
    if ! grep -qxF "$licence" <<<"$LICENCES"; then
      unknown+=$'\n'"  $package: ${licence:-none}"
    fi
  done <<<"$found"
  if [[ -n $unknown ]]; then
    fail "may we ship these? then add their licences to the list in ci.sh:$unknown"
  fi
}

dependencies() {
  cargo tree --workspace --locked --target all --edges normal,build --prefix none \
    --format '{l}|{p}' | sed '/^$/d; s/^ *//; s/ (\*)$//' | sort -u
}

step_lint() {
  needs_component clippy clippy
  cargo clippy --locked --workspace --all-targets --all-features -- -D warnings
}

# What failed stands at the end once more, for it happened long before.
step_test() {
  local told
  told=$(mktemp)
  if cargo test --locked --workspace --all-features --no-fail-fast 2>&1 | tee "$told"; then
    rm "$told"
  else
    grep -aE "^test .* FAILED$|^thread '.*panicked at|^error: test failed" -A3 "$told" || true
    rm "$told"
    return 1
  fi
}

step_doc() {
  local readme library
  RUSTDOCFLAGS="-D warnings" cargo doc --locked --workspace --all-features --no-deps
  for readme in crates/*/README.md page/README.md; do
    library=${readme%README.md}src/lib.rs
    [[ -e $library ]] || continue
    diff <(example_of_library "$library") <(example_of_readme "$readme") ||
      fail "$readme: the example is not that of $library (<), which is tested"
  done
}

# The first example of a library's documentation, without the lines that a reader does not see.
example_of_library() {
  sed -n 's/^\/\/! \{0,1\}//p' "$1" |
    awk '!within && /^```(no_run)?$/ { within = 1; next } within && /^```$/ { exit } within && !/^#( |$)/'
}

example_of_readme() {
  awk '/^```rust$/ { within = 1; next } within && /^```$/ { exit } within' "$1"
}

step_package() {
  local target folder crate
  target=${CARGO_TARGET_DIR:-target}
  folder=$target/unpacked
  rm -rf "$folder" "$target"/package/*.crate
  mkdir -p "$folder"
  cargo package --quiet --workspace --exclude dobot-fuzz --no-verify --allow-dirty --exclude-lockfile
  {
    printf '[workspace]\nresolver = "3"\nmembers = ["dobot-*"]\n[patch.crates-io]\n'
    for crate in "$target"/package/dobot-*.crate; do
      # With the time of now: in a package all files are of the same day, and a changed one would look unchanged.
      tar -xmzf "$crate" -C "$folder"
      crate=$(basename "$crate" .crate)
      printf '%s = { path = "%s" }\n' "${crate%-[0-9]*}" "$crate"
    done
    # The same profiles, so that what was built before is used.
    sed -n '/^\[profile/,$p' Cargo.toml
  } >"$folder/Cargo.toml"
  cp Cargo.lock "$folder"
  cargo check --manifest-path "$folder/Cargo.toml" --target-dir "$target" --workspace --all-features
}

step_no-std() {
  cargo run --locked --release --manifest-path tests/no-std/Cargo.toml --target-dir target/no-std
  echo "it links, and what it calculates is right"
}

# The command that each example names is what a person types; here the binaries that `test` has built are run, since a
# build of one package has other features than a build of all, and would compile the dependencies once more.
step_examples() {
  local file room name command
  build_all
  for file in crates/*/examples/*.rs crates/*/examples/*/main.rs; do
    [[ -e $file ]] || continue
    room=$(cut -d/ -f2 <<<"$file")
    name=${file#crates/*/examples/}
    name=${name%.rs}
    name=${name%/main}
    command=$(sed -n "1s/^\/\/! \`cargo run -p dobot-$room --example \($name\( -- [^\`]*\)\?\)\`.*/\1/p" "$file")
    if [[ -z $command ]]; then
      fail "$file: the first line is not the command that runs it, as in //! \`cargo run -p dobot-$room --example $name\`"
    fi
    run_example "$command"
  done
}

# The programs, with every feature, as `test` builds them: without the examples there would be no dependencies of
# tests, and with that other features, and all would be built once more.
build_all() {
  cargo build --locked --workspace --exclude dobot-fuzz --all-features --bins --examples
}

built() {
  echo "${CARGO_TARGET_DIR:-target}/debug"
}

run_example() {
  echo "\$ ${1/ -- / }"
  bash -c "'$(built)/examples/'${1/ -- / }" </dev/null
}

# The station says in a file where it is; its arm is a virtual one.
step_api() {
  local folder address station
  needs_venv
  needs_command curl curl
  needs_command node nodejs
  build_all
  folder=$(mktemp -d)
  "$(built)/dobot" up --virtual --http 127.0.0.1:0 --raw off --data "$folder" >"$folder/log" &
  station=$!
  STATION=$station
  for _ in {1..100}; do
    address=$(sed -n 's/^address = "\(.*\)"/\1/p' "$folder/station.toml" 2>/dev/null) || true
    [[ -n $address ]] && break
    sleep 0.1
  done
  [[ -n $address ]] || fail "the station does not start: $(cat "$folder/log")"
  # The library through a station; `examples` runs the same without one.
  run_example "move_and_jog -- '$address'"
  run_example "draw -- examples/drawings/square.svg '$address'"
  tests/api/examples.sh "$address"
  EXAMPLES=${EXAMPLES:-20} tests/api/schemathesis.sh "$address"
  kill -INT "$station"
  wait "$station"
  STATION=
  rm -rf "$folder"
}

step_models() {
  needs_venv
  build_all
  tests/models/check.sh "$(built)"
}

step_recordings() {
  local folder
  needs_venv
  folder=$(mktemp -d)
  DOBOT_RECORD_SAMPLES=$folder cargo test --locked --workspace --all-features --test repairs -- --exact samples --ignored
  tests/recordings/read.sh "$folder"
  rm -rf "$folder"
  mkdir "$folder"
  DOBOT_RECORD_SAMPLES=$folder cargo test --locked --workspace --all-features --test export -- --exact samples --ignored
  build_all
  tests/recordings/tables.sh "$(built)/dobot" "$folder"
  needs_command node nodejs
  needs_command npm npm
  rm -rf "$folder"
  mkdir "$folder"
  tests/foxglove/look_on.sh "$(realpath "$(built)/dobot")" "$folder"
  tests/recordings/read.sh "$folder" scene.py
  rm -rf "$folder"
}

step_fleet() {
  local folder
  needs_venv
  needs_command ip iproute2
  folder=$(mktemp -d)
  python3 -m venv "$folder"
  "$folder/bin/pip" install --quiet eclipse-zenoh
  build_all
  tests/fleet/class.sh "$(realpath "$(built)/dobot")" "$folder/bin/python"
  rm -rf "$folder"
  needs_command node nodejs
  needs_command npm npm
  needs_command chromium chromium
  npm ci --prefix page --no-audit --no-fund
  tests/fleet/board.sh "$(realpath "$(built)/dobot")" "$(command -v chromium)"
}

step_ros2() {
  needs_venv
  build_all
  tests/ros2/check.sh "$(built)"
}

step_python() {
  local folder program tests notebooks
  needs_venv
  needs_component clippy clippy
  cargo fmt --manifest-path python/Cargo.toml --check
  cargo clippy --locked --manifest-path python/Cargo.toml -- -D warnings
  folder=$(mktemp -d)
  python3 -m venv "$folder/venv"
  # Built for tests, in a third of the time: the wheel that people get is the one of release/wheel.sh.
  "$folder/venv/bin/pip" install --quiet --config-settings=build-args="--profile dev" ./python
  "$folder/venv/bin/pip" install --quiet ipykernel matplotlib mypy nbmake numpy pandas pandas-stubs pyarrow pyright pyserial pytest types-pyserial
  build_all
  program=$(realpath "$(built)/dobot")
  tests=$PWD/python/tests notebooks=$PWD/examples/notebooks
  # Elsewhere than beside the package's sources, so that the installed one is tested.
  (cd "$folder" && DOBOT=$program venv/bin/pytest --quiet -p no:cacheprovider "$tests" && venv/bin/pytest --quiet -p no:cacheprovider --nbmake "$notebooks" && venv/bin/mypy --strict "$tests" && venv/bin/mypy --strict -p dobot_arm \
    && venv/bin/pyright --pythonpath venv/bin/python "$tests" && venv/bin/pyright --pythonpath venv/bin/python venv/lib/python3*/site-packages/dobot_arm)
  rm -rf "$folder"
}

# The browser is Debian's, and playwright-core from npm moves the pointer in it.
step_page() {
  needs_command node nodejs
  needs_command npm npm
  needs_command chromium chromium
  build_all
  npm ci --prefix page --no-audit --no-fund
  DOBOT=$(realpath "$(built)/dobot")
  CHROMIUM=$(command -v chromium)
  export DOBOT CHROMIUM
  npm run vendor --prefix page -- --check
  npm run types --prefix page -- --check
  npm run check --prefix page
  npm run unit --prefix page
  npm run browser --prefix page
}

step_bench-check() {
  cargo test --locked --workspace --all-features --bench '*'
}

# How many inputs each fuzz target tries: what takes five to ten seconds.
readonly FUZZ_RUNS='dxf 50000
files 30000
firmware_1_1 3000
gcode 50000
hpgl 50000
lightburn 30000
mcap 50000
pictures 5000
points 50000
policy 20000
programs 10000
requests 1500
specification 3000
svg 10000
texts 50000
vendor_files 50000'

# Always the same inputs, so that the result is always the same: from the seeds alone, with the same random numbers.
step_fuzz() {
  build_fuzz
  export -f fuzz_target fuzz_some
  xargs -P "$(getconf _NPROCESSORS_ONLN)" -L 1 bash -c 'fuzz_some "$@"' fuzz <<<"$FUZZ_RUNS"
}

# Other inputs each time, from all that were found before; a minute of each target in turn, until the time is over or
# something is found.
step_fuzz-long() {
  local ends share=60
  build_fuzz
  ends=$((SECONDS + ${FUZZ_SECONDS:-1000000000}))
  export -f fuzz_target fuzz_longer
  while ((SECONDS < ends)); do
    share=$((ends - SECONDS < share ? ends - SECONDS : share))
    cut -d' ' -f1 <<<"$FUZZ_RUNS" |
      xargs -P "$(getconf _NPROCESSORS_ONLN)" -I{} bash -c "fuzz_longer {} $share"
  done
}

# What `cargo fuzz build --sanitizer none` does, without having to install it. There is no `unsafe` for a sanitizer to
# look into. `--target` keeps the flags from build scripts.
build_fuzz() {
  local host
  local -a coverage=(
    --cfg fuzzing -Cpasses=sancov-module -Cllvm-args=-sanitizer-coverage-level=4
    -Cllvm-args=-sanitizer-coverage-inline-8bit-counters
    -Cllvm-args=-sanitizer-coverage-pc-table
  )
  host=$(rustc -vV | sed -n 's/^host: //p')
  export FUZZ_FOLDER=${CARGO_TARGET_DIR:-target}/fuzz
  export FUZZ_PROGRAMS=$FUZZ_FOLDER/$host/fuzz
  needs_command c++ g++
  RUSTC_BOOTSTRAP=1 RUSTFLAGS="${coverage[*]}" cargo build --locked -p dobot-fuzz --features libfuzzer \
    --profile fuzz --target "$host" --target-dir "$FUZZ_FOLDER"
}

fuzz_some() {
  local corpus status=0
  corpus=$(mktemp -d)
  fuzz_target "$1" "$corpus" "-runs=$2" -seed=1 || status=$?
  rm -rf "$corpus"
  return "$status"
}

fuzz_longer() {
  mkdir -p "$FUZZ_FOLDER/corpus/$1"
  fuzz_target "$1" "$FUZZ_FOLDER/corpus/$1" "-max_total_time=$2"
}

# One target on one core; what it prints comes when it is over. What it finds becomes a test.
fuzz_target() {
  local target=$1 corpus=$2 status=0
  mkdir -p "$FUZZ_FOLDER/found"
  "$FUZZ_PROGRAMS/$target" "$corpus" "fuzz/seeds/$target" "${@:3}" "-artifact_prefix=$FUZZ_FOLDER/found/$target-" \
    -timeout=60 -max_len=1000 -print_final_stats=1 >"$FUZZ_FOLDER/$target.log" 2>&1 || status=$?
  if [[ $status == 0 ]]; then
    echo "$target: nothing found with $(sed -n 's/^stat::number_of_executed_units: *//p' "$FUZZ_FOLDER/$target.log") inputs"
  else
    printf '%s\n%s\n' "$target:" "$(tail -n 40 "$FUZZ_FOLDER/$target.log")"
  fi
  return "$status"
}

step_bench() {
  # A plain byte bridge, to compare the station with.
  needs_command socat socat
  cargo bench --locked --workspace --bench '*'
}

step_compare-vpype() {
  needs_drawings order_drawings
  needs_python vpype elkai
  target/compare/bin/python tests/compare/travel.py
}

step_compare-toppra() {
  needs_drawings plan_json
  needs_python toppra numpy
  target/compare/bin/python tests/compare/toppra_time.py target/drawings/*.svg
}

# The drawings that programs are compared on, and ours to be compared.
needs_drawings() {
  cargo run --locked --release -p dobot-draw --example benchmark_drawings -- target/drawings
  cargo build --locked --release -p dobot-draw --example "$1"
}

needs_python() {
  needs_venv
  [[ -x target/compare/bin/pip ]] || python3 -m venv target/compare
  target/compare/bin/pip install --quiet "$@"
}

# Installs a Debian package for a command where that is possible, and else says what to do.
needs_command() {
  local command=$1 package=$2
  if command -v "$command" >/dev/null; then
    return
  fi
  if [[ $EUID != 0 ]] || ! command -v apt-get >/dev/null; then
    fail "$command is missing; install it, on Debian with: apt-get install $package"
  fi
  apt-get update -q
  apt-get install -qy --no-install-recommends "$package"
}

# Python's virtual environments are a package of their own on Debian.
needs_venv() {
  needs_command python3 python3
  if ! python3 -c 'import ensurepip' 2>/dev/null; then
    [[ $EUID == 0 ]] && command -v apt-get >/dev/null || fail "python3 has no venv; on Debian: apt-get install python3-venv"
    apt-get update -q
    apt-get install -qy --no-install-recommends python3-venv
  fi
}

needs_component() {
  local subcommand=$1 component=$2
  if ! cargo "$subcommand" --version >/dev/null 2>&1; then
    fail "$component is missing; run: rustup component add $component"
  fi
}

main() {
  local names=("$@") name
  if [[ ${names[0]:-} =~ ^(help|-h|--help)$ ]]; then
    help
    return
  fi
  if [[ ${#names[@]} == 0 ]]; then
    mapfile -t names < <(printf '%s\n' "${CI_STEPS[@]%% *}")
  fi
  if [[ ${names[0]} == fuzz-long && ${names[1]:-} =~ ^[0-9]+$ ]]; then
    FUZZ_SECONDS=${names[1]}
    names=(fuzz-long "${names[@]:2}")
  fi
  for name in "${names[@]}"; do
    if [[ $name == *[!a-z0-9-]* ]] || ! declare -F "step_$name" >/dev/null; then
      help >&2
      fail "there is no step \`$name\`"
    fi
  done
  if ! command -v cargo >/dev/null; then
    fail "cargo is missing; https://rustup.rs tells how to install Rust"
  fi
  for name in "${names[@]}"; do
    run "$name"
  done
  echo "ci.sh: all passed (${names[*]}) in ${SECONDS} s"
}

run() {
  local name=$1 began=$SECONDS
  echo "==> $name"
  CURRENT=$name
  "step_$name"
  CURRENT=
  echo "<== $name: passed in $((SECONDS - began)) s"
  echo
}

help() {
  echo "./ci.sh [STEP...]   runs the steps named, or all of CI's:"
  printf '  %s\n' "${CI_STEPS[@]}"
  echo "others:"
  printf '  %s\n' "${OTHER_STEPS[@]}"
}

fail() {
  echo "error: $1" >&2
  exit 1
}

CURRENT=
STATION=
trap 'if [[ -n $STATION ]]; then kill "$STATION"; fi; if [[ -n $CURRENT ]]; then echo "ci.sh: $CURRENT failed" >&2; fi' EXIT
main "$@"
