#!/usr/bin/env bash
# The trial in one Debian, whose folder is the argument. Runs in namespaces of its own (release/trial.sh).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
ROOT=$1
readonly ROOT
readonly URL=http://127.0.0.1:8642

main() {
  local began=$SECONDS
  ip link set lo up
  mount -t proc proc "$ROOT/proc"
  mount -t devpts devpts "$ROOT/dev/pts" -o newinstance,ptmxmode=0666 2>/dev/null || true
  mount --rbind /dev/shm "$ROOT/dev/shm" 2>/dev/null || true

  step "install" chroot "$ROOT" dpkg --install /dobot.deb
  step "the program, its manual and its rule are there" present
  step "doctor" user 'dobot doctor || true'
  step "a port without permission names the command that gives it" permission
  user 'exec dobot up --virtual --no-open' >"$ROOT/up.log" 2>&1 &
  step "dobot starts and says where the page is" eventually grep -q "page *$URL" "$ROOT/up.log"
  (($(wc -l <"$ROOT/up.log") <= 10)) || fail "its first words have more than ten lines: $(cat "$ROOT/up.log")"
  cat "$ROOT/up.log"
  step "status" user 'dobot status --count 1'
  if command -v chromium node >/dev/null && [[ -d page/node_modules ]]; then
    step "the page moves the arm, in Chromium" page
  else
    echo "left out: the page needs chromium, node, and \`npm ci --prefix page\`"
  fi
  step "draw" user "dobot draw --text Hi --height 10 --picture /home/pupil/drawn.svg"
  step "teach" python3 release/trial/teach.py "$ROOT/home/pupil/taught.toml" chroot "$ROOT" su - pupil -c 'dobot teach taught.toml'
  step "play what was taught" user 'grep -q point taught.toml && dobot play taught.toml'
  step "stop" user 'dobot stop --reason trial'
  user 'dobot status --count 1' >/dev/null
  step "a stopped arm does not move" refused user 'dobot move 220 0 30'
  step "remove" chroot "$ROOT" dpkg --purge dobot
  step "nothing is left" absent
  echo "the trial took $((SECONDS - began)) s"
}

step() {
  local name=$1 log
  log=$(mktemp)
  shift
  if "$@" </dev/null >"$log" 2>&1; then
    echo "ok    $name"
  else
    cat "$log" "$ROOT/up.log" >&2
    fail "$name"
  fi
}

user() {
  chroot "$ROOT" su - pupil -c "$1"
}

present() {
  chroot "$ROOT" test -s /usr/share/man/man1/dobot.1.gz
  chroot "$ROOT" test -s /usr/share/bash-completion/completions/dobot
  chroot "$ROOT" grep -q uaccess /usr/lib/udev/rules.d/60-dobot.rules
  chroot "$ROOT" grep -q 'ExecStart=/usr/bin/dobot up' /usr/lib/systemd/system/dobot.service
  user 'dobot --version && dobot-ros2 --version'
}

permission() {
  local said
  mknod --mode 660 "$ROOT/dev/ttyUSB0" c 188 0
  chroot "$ROOT" chgrp dialout /dev/ttyUSB0
  said=$(user 'dobot status --to serial:/dev/ttyUSB0' 2>&1) && return 1
  rm "$ROOT/dev/ttyUSB0"
  grep -F 'sudo usermod -aG dialout $USER' <<<"$said"
}

page() {
  CHROMIUM=$(command -v chromium) node page/tests/trial.mjs "$URL" "$ROOT/page.png"
}

absent() {
  ! find "$ROOT"/{usr,etc,var} -iname '*dobot*' -not -path '*/dpkg/*' | grep .
}

eventually() {
  for _ in {1..300}; do
    ! "$@" || return 0
    sleep 0.1
  done
  return 1
}

refused() {
  ! "$@"
}

fail() {
  echo "error: $1" >&2
  exit 1
}

main
