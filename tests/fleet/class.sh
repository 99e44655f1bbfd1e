#!/usr/bin/env bash
# A class: three stations, each in a network of its own, a router between them that is killed, and a peer in Python that
# is none of ours.
#
#   class.sh PROGRAM PYTHON
#
# PROGRAM is a `dobot` with the feature `fleet`, PYTHON one that has PyPI's `eclipse-zenoh`. It takes namespaces for
# networks: as root, or where the system lets a user have some of his own.
set -euo pipefail
if [[ $(id -u) != 0 ]]; then
  exec unshare --user --map-root-user --net --mount "$0" "$@"
fi
# The names of the namespaces are this run's own.
if [[ -z ${DOBOT_CLASS:-} ]]; then
  DOBOT_CLASS=1 exec unshare --mount --pid --fork --kill-child "$0" "$@"
fi
mount -t tmpfs tmpfs /run
mount -t proc proc /proc
readonly PROGRAM=$1 PYTHON=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# Runs something in the network of a desk, or of the router, with its own data.
at() {
  local place=$1
  shift
  DOBOT_DATA=$work/$place ip netns exec "$place" "$@"
}

# Waits until the lines of `dobot fleet` at a desk have this many that match.
sees() {
  local place=$1 many=$2 what=$3 found='' end=$((SECONDS + 60))
  while ((SECONDS < end)); do
    found=$(at "$place" "$PROGRAM" fleet 2>&1 || true)
    if (($(grep -c "$what" <<<"$found" || true) == many)); then
      return 0
    fi
    read -rt 0.2 <> <(:) || true
  done
  echo "$place does not see $many lines with '$what':"$'\n'"$found" >&2
  cat "$work"/*.log >&2
  exit 1
}

start_router() {
  # The process that is killed is the router itself.
  (exec ip netns exec router "$PROGRAM" fleet router --listen tls/0.0.0.0:7447 --fleet=keys/router) >router.log 2>&1 &
  router=$!
}

"$PROGRAM" fleet certificates keys desk-1 desk-2 desk-3 router=127.0.0.1,10.7.1.1,10.7.2.1,10.7.3.1 peer >/dev/null
ip netns add router
ip -n router link set lo up
start_router
for number in 1 2 3; do
  desk=desk-$number
  ip netns add $desk
  ip -n $desk link set lo up
  ip link add out netns $desk type veth peer name to$number netns router
  ip -n $desk addr add 10.7.$number.2/24 dev out
  ip -n $desk link set out up
  ip -n router addr add 10.7.$number.1/24 dev to$number
  ip -n router link set to$number up
  at $desk "$PROGRAM" up --virtual --raw off --no-open --name $desk --group room-$((number / 2)) \
    --fleet=keys/$desk --connect tls/10.7.$number.1:7447 >$desk.log 2>&1 &
done
for number in 1 2 3; do
  sees desk-$number 3 free
done
echo "three stations see each other over the router"

token=$("$PROGRAM" token --data desk-2 add control peer)
at router "$PYTHON" "$here/peer.py" tls/127.0.0.1:7447 keys/peer desk-2 "$token"
sees desk-1 1 'stopped by peer: by a peer in Python'
sees desk-3 2 free
echo "a peer in Python read all states, and stopped desk-2 with a token"

kill -9 $router
sees desk-1 2 away
at desk-3 "$PROGRAM" stop >/dev/null
stopped=$(at desk-1 "$PROGRAM" fleet stop 2>&1 || true)
grep -q '^1 of 3 stopped$' <<<"$stopped"
grep -q '^desk-3: ' <<<"$stopped"
echo "without the router each station stops its own arm, and the others are said to be away"

start_router
sees desk-1 3 stopped
at desk-2 "$PROGRAM" stop --reset >/dev/null
sees desk-3 1 free
echo "with the router they find each other again"
