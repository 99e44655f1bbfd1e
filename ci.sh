#!/usr/bin/env bash
# Every check of this project. CI runs this script, and so can you.
#
#   ./ci.sh              the checks to run before you push
#   ./ci.sh wide         the remaining checks: rare features, other programs, packages, fuzzing
#   ./ci.sh STEP...      some steps
#   ./ci.sh help         all steps, one line each
#
# Rust and git are enough for most steps. `api` and `python` need Python, `page` needs Node and Chromium, `fuzz` needs a C++
# compiler. A missing program ends its step with the name of its Debian package; as root, the script installs it.
#
# - Everything is built once, in `target/`, with the profile `dev` and the same features (see tests/features): `lint` and `doc`
#   check, `test` builds, and the other steps use what `test` has built. `no-std` is the exception: it links only with
#   `panic = "abort"` and link-time optimisation, and it is small. `wide` adds the features `full` and `fleet`, and the crates `fleet`, `ros2` and `mcp`.
# - `lint` also rejects what the standard library gained after a crate's `rust-version` (clippy's `incompatible_msrv`).
# - `examples` runs the command in the first line of each example.
# - `test` uses a fixed seed for property tests, `random` a new one.
# - `bench-check` runs every benchmark once, unoptimised. `bench` measures; it needs a calm machine (docs/performance.md).
# - `fuzz` runs a fixed number of inputs from a fixed seed, so that it always gives the same result. What `fuzz-long` finds
#   becomes a seed in `fuzz/seeds`, which `cargo test` runs.
# - Python packages are pinned in `tests/python`, packages of npm in their lock files.
#
# Not checked here: other targets, which would have to be installed, and advisories, which change without a commit.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
# A build that is thrown away gains nothing from incremental compilation.
[[ -z ${CI:-} ]] || export CARGO_INCREMENTAL=0
# The Python module finds the interpreter's symbols when it is loaded.
export PYO3_BUILD_EXTENSION_MODULE=1

# Name and purpose of the steps. The cheap ones run first, then the two other lists side by side.
readonly CHEAP_STEPS=(
  "fmt          Is all code formatted?"
  "licences     Does every dependency have a licence that we may ship?"
  "lint         Run clippy; warnings are errors. Check the wording, spelling and the size of functions"
)
readonly CODE_STEPS=(
  "test         Run cargo test"
  "doc          Build the documentation; warnings are errors. Compare the READMEs with its examples, and docs/crates.md with the manifests"
  "no-std       Link wire, arm, motion and controller without the standard library"
  "examples     Run every example; none needs an arm"
  "api          Send a station requests that schemathesis makes from its OpenAPI document"
)
readonly CLIENT_STEPS=(
  "python       Run the Python package's tests and notebooks; check its types with mypy and pyright"
  "page         Check the page's types and packages, and run its unit tests"
  "browser      Test the page with a real pointer in a browser"
)
readonly PUSH_STEPS=("${CHEAP_STEPS[@]}" "${CODE_STEPS[@]}" "${CLIENT_STEPS[@]}")
readonly WIDE_STEPS=(
  "lint-all     Run clippy with all features"
  "test-all     Run the tests of the crates that have more features, with all of them"
  "random       Run the unit and property tests with a random seed"
  "doc-all      Build the documentation of the remaining crates"
  "workflows    Check the workflow files with actionlint, and the installation by the GitHub Action"
  "site         Build README and docs as a website, and check its links"
  "models       Load the arm's models with yourdfpy, MuJoCo, PyBullet, Drake and pinocchio, and compare the kinematics"
  "voice        Measure how well spoken orders are understood, with speech made by flite"
  "hands        Look for hands in pictures with MediaPipe's models, in a browser and in Python"
  "eyes         Measure the accuracy of the camera with 60 photos, and of the calibration from one photo with 200 arms"
  "python-full  Run the tests of the parts of the Python package that need the feature full"
  "recordings   Read recordings and tables with mcap, pandas, datasets and Rerun, and live data with Foxglove's client"
  "icons        Compare drawings of icons and styles with Chromium's pictures"
  "fleet        Run a class in three networks, with eclipse-zenoh as a peer and the board in browsers"
  "ros2         Use an arm over ROS 2 with cyclonedds"
  "agents       Use an arm with the Python and TypeScript libraries of the Model Context Protocol"
  "bench-check  Run every benchmark once, unoptimised"
  "fuzz         Run every fuzz target with a fixed number of inputs"
  "release      Build everything that is distributed, and use it in Debian 11 to 13 and Python 3.10 to 3.13 as a new user"
)
readonly OTHER_STEPS=(
  "times          Print the build and test times of the last run"
  "budget         Print the number of packages and the five largest libraries"
  "fuzz-long      Fuzz with random seeds for FUZZ_SECONDS, or until you stop it"
  "bench          Run all benchmarks (docs/performance.md)"
  "compare-vpype  Compare pen-up travel with vpype and LKH; takes an hour"
  "compare-plan   Compare the time of Python's plan with vpype's"
  "compare-saxi   Compare the time from file to plan with saxi's modules"
  "compare-toppra Compare arm time with the time-optimal motion of toppra"
  "lerobot        Load a dataset with LeRobot's own loader, which needs 7 GB of disk"
)

# Crates that take minutes to build and that few people change; `wide` tests them.
readonly RARE=(--exclude dobot-fleet --exclude dobot-ros2 --exclude dobot-mcp)
# The crates that `cargo test` does not build, or not with all features.
readonly FEATURED=(-p dobot-api -p dobot-cli -p dobot-fleet -p dobot-mcp -p dobot-ros2 -p dobot-record -p dobot-station
  -p dobot-arm-python -p dobot-examples -p dobot-features)

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
  for package in crates/* page; do
    for licence in LICENSE-MIT LICENSE-APACHE; do
      cmp -s "$package/$licence" "$licence" || fail "$package/$licence is not a link to $licence: a package would lack its licence"
    done
  done
}

dependencies() {
  cargo tree --workspace --exclude dobot-fuzz --locked --target all --edges normal,build --prefix none \
    --format '{l}|{p}' | sed '/^$/d; s/^ *//; s/ (\*)$//' | sort -u
}

step_lint() {
  needs_component clippy clippy
  build cargo clippy --locked --workspace "${RARE[@]}" --all-targets -- -D warnings
  check_words
  check_sizes
  check_levels
}

# Words that a reader stumbles over (tests/lint/words.txt), and misspelled ones (_typos.toml).
check_words() {
  local found
  # `told` is a field of the API.
  found=$(git grep -nIiEf tests/lint/words.txt -- '*.md' page/files 'crates/*/src/*' python/src python/dobot_arm \
    ':!page/files/vendor' ':!docs/style.md' ':!*tests*' ':!*.test.js' |
    grep -viE '[.`"/]told\b|\btold[?]?: ' || true)
  if [[ -n $found ]]; then
    echo "$found" | cut -c1-200
    fail "use the plain word instead (docs/style.md)"
  fi
  needs_packages lint
  "$VENV/bin/typos" || fail "correct the spelling, or add the word to _typos.toml"
}

# A function has at most 80 lines, except for a table, which says so by a comment: `// table`.
check_sizes() {
  local sizes long
  sizes=$(git ls-files 'crates/*/src/*.rs' 'page/src/*.rs' 'python/src/*.rs' | grep -v /tests |
    xargs awk -f tests/lint/sizes.awk | sort -n)
  awk '{ lines[NR] = $1 }
    END { print NR " functions; lines: median " lines[int((NR + 1) / 2)] ", 95 % at most " lines[int(NR * 0.95)] }' <<<"$sizes"
  long=$(awk '$1 > 80 && $4 != "table"' <<<"$sizes")
  [[ -z $long ]] || fail "functions of over 80 lines:"$'\n'"$long"
}

# A crate that `cargo build --release` hardly optimises has another level in what is released.
check_levels() {
  local forgotten
  forgotten=$(comm -23 <(levels release | sed -n 's/\.opt-level = [01]$//p' | sort) <(levels dist | sed 's/\..*//' | sort))
  [[ -z $forgotten ]] || fail "these crates need a level in [profile.dist.package] of Cargo.toml:"$'\n'"$forgotten"
}

levels() {
  sed -n "/^\[profile\.$1\.package\]/,/^$/p" Cargo.toml | grep '^[a-z]'
}

step_lint-all() {
  needs_component clippy clippy
  build cargo clippy --locked --all-features "${FEATURED[@]}" --lib --bins --tests --examples -- -D warnings
  build cargo clippy --locked -p dobot-sim --no-default-features --lib --tests -- -D warnings
}

# The tests of `cargo test`. The selection of packages is that of the other steps, so that one build serves all.
step_test() {
  build_all
  report_failures cargo test --locked --workspace "${RARE[@]}" --lib --bins --tests --no-fail-fast
  report_failures cargo test --locked --workspace "${RARE[@]}" --doc --no-fail-fast
}

# Of the tests of the program itself, only those that a plain build does not have.
step_test-all() {
  build_rare
  report_failures cargo test --locked --all-features "${FEATURED[@]}" --lib --bins --test it --no-fail-fast
  report_failures cargo test --locked --all-features "${FEATURED[@]}" --test process --no-fail-fast -- \
    agents:: arguments::full:: datasets:: http_agents:: together::
  report_failures cargo test --locked -p dobot-sim --no-default-features --lib --tests --no-fail-fast
  report_failures cargo test --locked --all-features "${FEATURED[@]}" --doc --no-fail-fast
}

step_random() {
  export PROPTEST_RNG_SEED=$RANDOM
  echo "PROPTEST_RNG_SEED=$PROPTEST_RNG_SEED"
  report_failures cargo test --locked --workspace "${RARE[@]}" --lib --bins --test it --no-fail-fast
}

# Repeats the failures at the end, where they are found.
report_failures() {
  local log
  log=$(mktemp)
  if "$@" 2>&1 | tee "$log"; then
    rm "$log"
  else
    grep -aE "^test .* FAILED$|^thread '.*panicked at|^error: test failed" -A3 "$log" || true
    rm "$log"
    return 1
  fi
}

step_doc() {
  local readme library
  RUSTDOCFLAGS="-D warnings" build cargo doc --locked --workspace "${RARE[@]}" --no-deps
  for readme in crates/*/README.md page/README.md; do
    library=${readme%README.md}src/lib.rs
    [[ -e $library ]] || continue
    diff <(example_of_library "$library") <(example_of_readme "$readme") ||
      fail "$readme: the example is not that of $library (<), which is tested"
  done
  build_all
  diff <("$(built)/examples/crates") docs/crates.md ||
    fail "docs/crates.md is not what the manifests say (<); regenerate it (docs/recipes.md)"
  diff <(docs/draw-options.sh "$DOBOT") docs/draw-options.md ||
    fail "docs/draw-options.md is not what dobot draw --help prints (<); regenerate it (docs/recipes.md)"
}

step_doc-all() {
  RUSTDOCFLAGS="-D warnings" build cargo doc --locked --all-features "${FEATURED[@]}" --no-deps
}

# The first example of a library's documentation, without its hidden lines.
example_of_library() {
  sed -n 's/^\/\/! \{0,1\}//p' "$1" |
    awk '/^```/ { if (within) exit; if (other) other = 0; else if (/^```(no_run)?$/) within = 1; else other = 1; next }
      within && !/^#( |$)/'
}

example_of_readme() {
  awk '/^```rust$/ { within = 1; next } within && /^```$/ { exit } within' "$1"
}

step_workflows() {
  needs_command node nodejs
  needs_command npm npm
  npm ci --prefix tests/workflows --no-audit --no-fund
  node tests/workflows/check.mjs .github/workflows/*.yml examples/github-actions/*.yml
  tests/workflows/install.sh
}

step_site() {
  needs_packages wide
  docs/site.sh "$VENV/bin/mdbook"
}

step_release() {
  if [[ $EUID == 0 ]]; then
    needs_command debootstrap debootstrap
    needs_command ip iproute2
    needs_browser
  fi
  build release/all.sh
  release/image.sh
  release/trial.sh
}

step_no-std() {
  build cargo build --locked --release --manifest-path tests/no-std/Cargo.toml --target-dir target/no-std
  target/no-std/release/dobot-no-std
  echo "it links, and its results are right"
}

# What the steps run: tests, programs, examples, the Python module.
build_all() {
  build cargo build --locked --workspace "${RARE[@]}" --lib --bins --tests --examples
}

# The same for the rare crates and features.
build_rare() {
  build cargo build --locked --all-features "${FEATURED[@]}" --lib --bins --tests --examples
}

built() {
  echo "${CARGO_TARGET_DIR:-target}/debug"
}

# Runs the command in the first line of each example.
step_examples() {
  local file name command
  build_all
  for file in examples/rust/examples/*.rs examples/rust/examples/*/main.rs; do
    name=${file#examples/rust/examples/}
    name=${name%.rs}
    name=${name%/main}
    # Its command needs the feature `fleet`.
    [[ $name != scale ]] || continue
    command=$(sed -n "1s/^\/\/! \`cargo run -p dobot-examples --example \($name\( -- [^\`]*\)\?\)\`.*/\1/p" "$file")
    if [[ -z $command ]]; then
      fail "$file: the first line is not its command, as in //! \`cargo run -p dobot-examples --example $name\`"
    fi
    run_example "$command"
  done
}

run_example() {
  echo "\$ ${1/ -- / }"
  bash -c "'$(built)/examples/'${1/ -- / }" </dev/null
}

# The station writes its address to a file; its arm is a virtual one.
step_api() {
  local folder address station
  needs_packages ci
  needs_command curl curl
  needs_command node nodejs
  build_all
  folder=$(mktemp -d)
  "$(built)/dobot" up --virtual --http 127.0.0.1:0 --raw off --data "$folder" >"$folder/log" &
  station=$!
  STATION=$station
  for _ in {1..300}; do
    address=$(sed -n 's/^address = "\(.*\)"/\1/p' "$folder/station.toml" 2>/dev/null) || true
    [[ -n $address ]] && break
    sleep 0.1
  done
  [[ -n $address ]] || fail "the station does not start: $(cat "$folder/log")"
  # The library through a station; `examples` runs the same without one.
  run_example "move_and_jog -- '$address'"
  run_example "draw -- examples/drawings/square.svg '$address'"
  tests/api/examples.sh "$address"
  EXAMPLES=${EXAMPLES:-20} SCHEMATHESIS=$VENV/bin/schemathesis tests/api/schemathesis.sh "$address"
  kill -INT "$station"
  wait "$station"
  STATION=
  rm -rf "$folder"
}

step_models() {
  needs_packages wide
  build_rare
  PATH=$VENV/bin:$PATH tests/models/check.sh "$(built)"
}

step_recordings() {
  local folder
  needs_packages wide
  needs_page
  build_rare
  folder=$(mktemp -d)
  export PATH=$VENV/bin:$PATH
  DOBOT_RECORD_SAMPLES=$folder cargo test --locked --all-features "${FEATURED[@]}" -p dobot-record --test it -- --exact repairs::samples --ignored
  tests/recordings/read.sh "$folder"
  rm -rf "$folder"
  mkdir "$folder"
  record_session "$folder"
  tests/recordings/tables.sh "$(built)/dobot" "$folder"
  rm -rf "$folder"
  mkdir "$folder"
  tests/foxglove/look_on.sh "$DOBOT" "$folder"
  tests/recordings/read.sh "$folder" scene.py
  mkdir "$folder/copy"
  "$DOBOT" log "$folder"/*.mcap --export protobuf -o "$folder/copy/scene.mcap"
  python3 tests/recordings/protobuf.py "$folder"/*.mcap "$folder/copy/scene.mcap"
  rm -rf "$folder"
}

step_fleet() {
  needs_packages wide
  needs_command ip iproute2
  needs_browser
  build_rare
  tests/fleet/class.sh "$DOBOT" "$VENV/bin/python"
  tests/fleet/board.sh "$DOBOT" "$CHROMIUM"
  npm run browser:fleet --prefix page
}

step_ros2() {
  needs_packages wide
  build_rare
  PATH=$VENV/bin:$PATH tests/ros2/check.sh "$(built)"
}

step_agents() {
  needs_packages wide
  needs_command node nodejs
  needs_command npm npm
  npm ci --prefix tests/agents --no-audit --no-fund
  build_rare
  PATH=$VENV/bin:$PATH tests/agents/check.sh "$DOBOT"
}

# The module is built with the other crates and put beside the package's Python files; release/wheel.sh builds the wheel.
step_python() {
  local folder tests=$PWD/python/tests notebooks=$PWD/examples/notebooks
  needs_packages ci
  needs_command flite flite
  build_all
  folder=$(assembled_package)
  use_photos
  (
    # Away from the sources, so that the assembled package is tested.
    cd "$folder"
    export PYTHONPATH=$folder MYPYPATH=$folder
    "$VENV/bin/pytest" --quiet -p no:cacheprovider --ignore "$tests/full" "$tests"
    "$VENV/bin/pytest" --quiet -p no:cacheprovider --nbmake "$notebooks"
    "$VENV/bin/mypy" --strict "$tests"
    "$VENV/bin/mypy" --strict -p dobot_arm
    "$VENV/bin/stubtest" dobot_arm --ignore-disjoint-bases --allowlist "$tests/stubtest.txt"
    "$VENV/bin/pyright" --pythonpath "$VENV/bin/python" "$tests" "$folder/dobot_arm"
    "$VENV/bin/pyright" --pythonpath "$VENV/bin/python" --verifytypes dobot_arm --ignoreexternal
  )
  rm -rf "$folder"
}

# The program that renders photos for the tests of the camera.
use_photos() {
  PHOTOS=$(realpath "$(built)/examples/photos")
  export PHOTOS
}

# More voices and sentences than the tests of the Python package use.
step_voice() {
  local folder tests=$PWD/python/tests
  needs_packages ci
  needs_command flite flite
  build_all
  folder=$(assembled_package)
  (
    cd "$folder"
    VOICE_ALL=1 PYTHONPATH=$folder "$VENV/bin/pytest" --quiet -rP -p no:cacheprovider "$tests/test_voice.py" -k "understood or chatter or stop_is"
  )
  rm -rf "$folder"
}

# The optional part that the page uses, and pictures of hands, from npm; and the Python package's extra.
step_hands() {
  local folder package
  needs_packages ci
  needs_packages hands "$VENV-hands"
  needs_browser
  build_all
  folder=$(mktemp -d)
  npm pack --silent --pack-destination "$folder" @mediapipe/hands@0.4.1675469240 fingerpose@0.1.0
  "$VENV/bin/python" tests/hands/video.py "$folder/fingerpose-0.1.0.tgz" "$folder/hands.y4m"
  HANDS=$folder/mediapipe-hands-0.4.1675469240.tgz HAND_VIDEO=$folder/hands.y4m node --test page/tests/follow_hand.test.mjs
  package=$(assembled_package)
  PYTHONPATH=$package "$VENV-hands/bin/python" tests/hands/follow.py "$folder/hands.y4m"
  rm -rf "$folder" "$package"
}

# More photos than the tests of the page and of the Python package use.
step_eyes() {
  local folder tests=$PWD/python/tests
  needs_packages ci
  needs_page
  build_all
  use_photos
  PHOTOS_COUNT=60 node --test page/tests/look_accuracy.test.mjs
  folder=$(assembled_package)
  (
    cd "$folder"
    PHOTOS_ARMS=200 PYTHONPATH=$folder "$VENV/bin/pytest" --quiet -rP -p no:cacheprovider "$tests/test_vision.py" -k one_photo
  )
  rm -rf "$folder"
}

# Parts that only a module with the feature `full` has.
step_python-full() {
  local folder tests=$PWD/python/tests/full
  needs_packages wide
  build_rare
  folder=$(assembled_package)
  (cd "$folder" && PYTHONPATH=$folder "$VENV/bin/pytest" --quiet -p no:cacheprovider "$tests")
  rm -rf "$folder"
}

# A folder with the package's Python files and the module that was built last, or that of a folder.
assembled_package() {
  local folder
  folder=$(mktemp -d)
  cp -r python/dobot_arm "$folder"
  cp "${1:-$(built)}/lib_core.so" "$folder/dobot_arm/_core.abi3.so"
  # The pytest plug-in is an entry point of the installed package.
  mkdir "$folder/dobot_arm-0.dist-info"
  printf 'Metadata-Version: 2.1\nName: dobot-arm\nVersion: 0\n' >"$folder/dobot_arm-0.dist-info/METADATA"
  printf '[pytest11]\ndobot-arm = dobot_arm.pytest_plugin\n' >"$folder/dobot_arm-0.dist-info/entry_points.txt"
  echo "$folder"
}

step_page() {
  needs_page
  build_all
  npm run vendor --prefix page -- --check
  npm run types --prefix page -- --check
  npm run check --prefix page
  npm run unit --prefix page
}

step_browser() {
  needs_browser
  build_all
  npm run browser --prefix page
}

needs_page() {
  needs_command node nodejs
  needs_command npm npm
  npm ci --prefix page --no-audit --no-fund
}

# Debian's Chromium, driven by playwright-core. Its shell halves the CPU time of most tests.
needs_browser() {
  needs_page
  needs_chromium
  needs_command chromium-headless-shell chromium-headless-shell
}

needs_chromium() {
  needs_command chromium chromium
  CHROMIUM=$(command -v chromium)
  export CHROMIUM
}

step_icons() {
  needs_command node nodejs
  needs_command npm npm
  needs_chromium
  npm ci --prefix tests/icons --no-audit --no-fund
  cargo build --locked -p dobot-import --example strokes
  node tests/icons/compare.mjs "$(built)/examples/strokes"
}

step_bench-check() {
  build cargo test --locked --workspace "${RARE[@]}" --bench '*' --no-run
  cargo test --locked --workspace "${RARE[@]}" --bench '*'
}

step_bench() {
  # A plain byte bridge, to compare the station with.
  needs_command socat socat
  cargo bench --locked --workspace "${RARE[@]}" --bench '*'
}

# The number of inputs for each fuzz target: five to ten seconds.
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

# The same inputs each time: made from the seeds alone, with a fixed random seed.
step_fuzz() {
  build_fuzz
  export -f fuzz_target fuzz_some
  xargs -P "$(getconf _NPROCESSORS_ONLN)" -L 1 bash -c 'fuzz_some "$@"' fuzz <<<"$FUZZ_RUNS"
}

# Other inputs each time, made from all that were found before. Each target runs for a minute in turn, until the time is over or
# a target fails.
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
  RUSTC_BOOTSTRAP=1 RUSTFLAGS="${coverage[*]}" build cargo build --locked -p dobot-fuzz --features libfuzzer \
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

# One target on one core. It prints its log only if it fails; what it finds becomes a seed.
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

step_compare-vpype() {
  needs_drawings order_drawings
  needs_packages compare
  "$VENV/bin/python" tests/compare/travel.py
}

step_compare-plan() {
  local release=${CARGO_TARGET_DIR:-target}/release folder
  needs_packages compare
  cargo build --locked --release -p dobot-arm-python
  folder=$(assembled_package "$release")
  PYTHONPATH=$folder "$VENV/bin/python" tests/compare/plan_time.py
  rm -rf "$folder"
}

step_compare-saxi() {
  local modules=$PWD/target/saxi/ lines=target/lines
  needs_drawings plan_time
  needs_command npm npm
  npm install --prefix "$modules" --no-save --ignore-scripts --no-audit --no-fund saxi@0.15.0
  mkdir -p "$lines"
  "${CARGO_TARGET_DIR:-target}/release/examples/plan_time" "$lines" target/drawings/{text,engraving,circuit}.svg \
    examples/drawings/still-life.jpg >"$lines/figures.jsonl"
  node tests/compare/saxi.mjs "$lines" "$lines/figures.jsonl" "$modules"
}

step_compare-toppra() {
  needs_drawings plan_json
  needs_packages compare
  "$VENV/bin/python" tests/compare/toppra_time.py target/drawings/*.svg
}

step_lerobot() {
  local folder
  needs_packages lerobot "$VENV-lerobot"
  build_rare
  folder=$(mktemp -d)
  record_session "$folder"
  "$(built)/dobot" log "$folder"/*.mcap --export lerobot --task "Turn." -o "$folder/dataset"
  HF_HOME=$folder/cache HF_HUB_OFFLINE=1 "$VENV-lerobot/bin/python" tests/recordings/load_lerobot.py "$folder/dataset"
  rm -rf "$folder"
}

# Records a session with pauses and rejected commands in the given folder.
record_session() {
  DOBOT_RECORD_SAMPLES=$1 cargo test --locked --all-features "${FEATURED[@]}" -p dobot-record --test it -- --exact export::samples --ignored
}

# The drawings to compare programs on, and our example that processes them.
needs_drawings() {
  cargo run --locked --release -p dobot-examples --example benchmark_drawings -- target/drawings
  cargo build --locked --release -p dobot-examples --example "$1"
}

# The number of packages in the program of a plain clone, and what takes most space in a build.
step_budget() {
  local packages
  packages=$(cargo tree --locked -p dobot-cli --edges normal,build --prefix none --format '{p}' | sed 's/ (\*)$//' | sort -u | wc -l)
  echo "packages: $packages (at most 291)"
  ((packages <= 291)) || fail "$packages packages; which of them does a plain clone need?"
  echo "largest libraries in $(built):"
  find "$(built)/deps" -name '*.rlib' -printf '%s %f\n' | sed 's/ lib\(.*\)-[0-9a-f]*\.rlib$/ \1/' | sort -rn |
    awk '!seen[$2]++ && n++ < 5 { printf "  %5.1f MB  %s\n", $1 / 1e6, $2 }'
}

# One virtual environment for all steps, or the one named. The packages in tests/python/NAME.txt are installed the first time.
needs_packages() {
  local list=tests/python/$1.txt venv=${2:-$VENV}
  if [[ -n $INSTALLING ]]; then
    wait "$INSTALLING" || true
    INSTALLING=
  fi
  needs_venv
  if ! cmp -s "$list" "$venv/$1.txt"; then
    [[ -x $venv/bin/pip ]] || python3 -m venv "$venv"
    "$venv/bin/pip" install --quiet --disable-pip-version-check --no-deps -r "$list"
    # Written last: an interrupted installation is done again.
    cp "$list" "$venv/$1.txt"
  fi
}

# Installs Python packages while cargo builds.
install_packages_early() {
  case " $* " in
    *" agents "* | *" models "* | *" site "* | *" recordings "* | *" fleet "* | *" ros2 "*) needs_packages wide >/dev/null 2>&1 & ;;
    *" api "* | *" python "* | *" voice "* | *" hands "* | *" eyes "*) needs_packages ci >/dev/null 2>&1 & ;;
    *) return ;;
  esac
  INSTALLING=$!
}

# Installs a Debian package for a command where that is possible, and otherwise names it.
needs_command() {
  local command=$1 package=$2
  if ! command -v "$command" >/dev/null; then
    install_package "$command is missing" "$package"
  fi
}

# Python's virtual environments are a package of their own on Debian.
needs_venv() {
  needs_command python3 python3
  if ! python3 -c 'import ensurepip' 2>/dev/null; then
    install_package "python3 has no venv" python3-venv
  fi
}

install_package() {
  if [[ $EUID != 0 ]] || ! command -v apt-get >/dev/null; then
    fail "$1; install it, on Debian with: apt-get install $2"
  fi
  apt-get update -q
  apt-get install -qy --no-install-recommends "$2"
}

needs_component() {
  local subcommand=$1 component=$2
  if ! cargo "$subcommand" --version >/dev/null 2>&1; then
    fail "$component is missing; run: rustup component add $component"
  fi
}

main() {
  local names=("$@") name
  case ${names[0]:-push} in
    push) mapfile -t names < <(printf '%s\n' "${PUSH_STEPS[@]%% *}") ;;
    wide) mapfile -t names < <(printf '%s\n' "${WIDE_STEPS[@]%% *}") ;;
    times) exec cat "$TIMES" ;;
    help | -h | --help)
      help
      return
      ;;
  esac
  for name in "${names[@]}"; do
    if [[ $name == *[!a-z0-9-]* ]] || ! declare -F "step_$name" >/dev/null; then
      help >&2
      fail "there is no step \`$name\`"
    fi
  done
  if ! command -v cargo >/dev/null; then
    fail "cargo is missing; install Rust from https://rustup.rs"
  fi
  mkdir -p target
  : >"$FAILURES"
  printf '%-12s %8s %8s\n' step 'build s' 'test s' >"$TIMES"
  install_packages_early "${names[@]}"
  if [[ ${1:-push} == push ]]; then
    run_push_steps
  else
    run_in_turn "${names[@]}"
  fi
  printf '%-12s %17s\n' total "$SECONDS" >>"$TIMES"
  cat "$TIMES"
  [[ ${1:-push} != push ]] || step_budget
  echo "ci.sh: all passed (${names[*]}) in $SECONDS s"
}

# The tests of processes, of the page and of the Python package wait more than they compute: two lanes share the cores. The clients'
# lane prints when it is done.
run_push_steps() {
  local failed=0 output=target/ci-clients.txt
  run_in_turn "${CHEAP_STEPS[@]%% *}"
  # Both lanes use them.
  needs_packages ci
  # Each lane gets a process group: an interrupted run ends what it has started.
  set -m
  lane "${CODE_STEPS[@]%% *}" </dev/null &
  LANES+=("$!")
  lane "${CLIENT_STEPS[@]%% *}" </dev/null >"$output" 2>&1 &
  LANES+=("$!")
  set +m
  wait "${LANES[0]}" || failed=1
  wait "${LANES[1]}" || failed=1
  LANES=()
  cat "$output"
  ((failed == 0)) || {
    cat "$FAILURES"
    exit 1
  }
}

lane() {
  LANES=()
  trap on_exit EXIT
  run_in_turn "$@"
}

run_in_turn() {
  local name
  for name in "$@"; do
    run "$name"
  done
}

on_exit() {
  local lane
  for lane in "${LANES[@]}"; do
    kill -- "-$lane" || true
  done
  [[ -z $STATION ]] || kill "$STATION"
  [[ -z $CURRENT ]] || echo "ci.sh: $CURRENT failed" | tee -a "$FAILURES" >&2
}

run() {
  local name=$1 began=$SECONDS
  echo "==> $name"
  CURRENT=$name
  BUILT=0
  "step_$name"
  CURRENT=
  printf '%-12s %8s %8s\n' "$name" "$BUILT" "$((SECONDS - began - BUILT))" >>"$TIMES"
  echo "<== $name: built in $BUILT s, tested in $((SECONDS - began - BUILT)) s"
  echo
}

# Runs a command whose time counts as building.
build() {
  local began=$SECONDS
  "$@"
  BUILT=$((BUILT + SECONDS - began))
}

help() {
  echo "./ci.sh [STEP...]   runs these steps, or those named:"
  printf '  %s\n' "${PUSH_STEPS[@]}"
  echo "./ci.sh wide        runs:"
  printf '  %s\n' "${WIDE_STEPS[@]}"
  echo "others:"
  printf '  %s\n' "${OTHER_STEPS[@]}"
}

fail() {
  echo "error: $1" >&2
  exit 1
}

DOBOT=$(built)/dobot
[[ $DOBOT == /* ]] || DOBOT=$PWD/$DOBOT
export DOBOT
readonly TIMES=target/ci-times.txt
readonly FAILURES=target/ci-failures.txt
readonly VENV=$PWD/target/venv
CURRENT=
STATION=
INSTALLING=
BUILT=0
LANES=()
trap on_exit EXIT
main "$@"
