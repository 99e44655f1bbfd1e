#!/usr/bin/env bash
# Builds the Debian package from the folder that release/archive.sh leaves:
#
#   release/deb.sh x86_64-unknown-linux-gnu
#
# The service is installed and not started: `sudo systemctl enable --now dobot` starts it, as a user of its own.
source "$(dirname "${BASH_SOURCE[0]}")/settings.sh"

main() {
  local root=$BUILD/stage/deb size file
  rm -rf "$root"
  install -d "$root"/usr/{bin,lib/systemd/system/dobot.service.d,lib/udev/rules.d,share/man/man1,share/doc/dobot} \
    "$root"/usr/share/{bash-completion/completions,zsh/vendor-completions,fish/vendor_completions.d} "$root/DEBIAN"
  install -m 755 "$STAGE/dobot" "$STAGE/dobot-ros2" "$root/usr/bin"
  install -m 644 "$STAGE/60-dobot.rules" "$root/usr/lib/udev/rules.d"
  install -m 644 "$STAGE/completions/dobot.bash" "$root/usr/share/bash-completion/completions/dobot"
  install -m 644 "$STAGE/completions/dobot.zsh" "$root/usr/share/zsh/vendor-completions/_dobot"
  install -m 644 "$STAGE/completions/dobot.fish" "$root/usr/share/fish/vendor_completions.d/dobot.fish"
  install -m 644 "$STAGE"/{README.md,SECURITY.md,LICENSES-OF-OTHERS.txt,parts.cdx.json} "$root/usr/share/doc/dobot"
  cat "$STAGE"/LICENSE{,-MIT,-APACHE} >"$root/usr/share/doc/dobot/copyright"
  gzip -9nc "$STAGE/CHANGELOG.md" >"$root/usr/share/doc/dobot/changelog.gz"
  for file in "$STAGE"/man/*.1; do
    gzip -9nc "$file" >"$root/usr/share/man/man1/${file##*/}.gz"
  done
  service "$root/usr/lib/systemd/system"

  size=$(find "$root/usr" -type f -printf '%s\n' | awk '{ sum += $1 } END { print int(sum / 1024) + 1 }')
  control "$size" >"$root/DEBIAN/control"
  script postinst <<<"$POSTINST"
  script prerm <<<"$PRERM"
  script postrm <<<"$POSTRM"
  find "$root" -exec touch --no-dereference --date "@$SOURCE_DATE_EPOCH" {} +
  file=$PRODUCTS/dobot_${VERSION}_amd64.deb
  mkdir -p "$PRODUCTS"
  dpkg-deb --root-owner-group -Zxz --build "$root" "$file" >/dev/null
  at_most "$file" 25000000
}

service() {
  "$STAGE/dobot" service print --system | sed "s|$STAGE/dobot|/usr/bin/dobot|" >"$1/dobot.service"
  printf '[Service]\nDynamicUser=yes\nSupplementaryGroups=dialout\n' >"$1/dobot.service.d/user.conf"
}

control() {
  cat <<END
Package: dobot
Version: $VERSION
Architecture: amd64
Maintainer: The authors of dobot <security@example.org>
Installed-Size: $1
Depends: libc6 (>= $GLIBC)
Section: electronics
Priority: optional
Homepage: $(sed -n 's/^repository = "\(.*\)"/\1/p' Cargo.toml)
Description: control of the original Dobot Arm, real or virtual
 A station with a web page that moves, teaches and draws with the Dobot Arm V1.0
 of 2016, a virtual arm, and tools for its protocol, agents, ROS 2 and fleets.
END
}

script() {
  local file=$BUILD/stage/deb/DEBIAN/$1
  { printf '#!/bin/sh\nset -e\n' && cat; } >"$file"
  chmod 755 "$file"
}

# An arm that is plugged in gets its rights at once.
readonly POSTINST='if command -v udevadm >/dev/null && [ -d /run/udev ]; then
  udevadm control --reload || true
  udevadm trigger --subsystem-match=tty || true
fi
if [ -d /run/systemd/system ]; then
  systemctl daemon-reload || true
  [ -z "$2" ] || systemctl try-restart dobot || true
fi'

readonly PRERM='if [ "$1" = remove ] && [ -d /run/systemd/system ]; then
  systemctl disable --now dobot || true
fi'

# The jobs and recordings of the service stay until `apt-get purge dobot`; those of users are theirs.
readonly POSTRM='if [ -d /run/udev ] && command -v udevadm >/dev/null; then
  udevadm control --reload || true
fi
if [ -d /run/systemd/system ]; then
  systemctl daemon-reload || true
fi
if [ "$1" = purge ]; then
  rm -rf /var/lib/dobot /var/lib/private/dobot
fi'

main
