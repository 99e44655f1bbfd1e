#!/usr/bin/env bash
# A class: three stations, each in a network of its own, a router between them that is killed, and a peer in Python that
# is none of ours.
#
#   class.sh PROGRAM PYTHON
#
# PROGRAM is a `dobot` with the feature `fleet`, PYTHON one that has PyPI's `eclipse-zenoh`.
set -euo pipefail
shopt -s extglob
readonly PROGRAM=$1 PYTHON=$2
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
source "$here/networks.sh"

# Runs something in the network of a desk, or of the router, with its own data. The stations without a router are at desk-1.
at() {
  local place=$1 network=${1/#@(alone|loopback)/desk-1}
  shift
  DOBOT_DATA=$work/$place ip netns exec "$network" "$@"
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
  (exec ip netns exec router "$PROGRAM" fleet router --listen quic/0.0.0.0:7447 --fleet=keys/router) >router.log 2>&1 &
  router=$!
}

make_networks "$PROGRAM"
start_router
for number in 1 2 3; do
  desk=desk-$number
  at $desk "$PROGRAM" up --virtual --raw off --no-open --name $desk --group room-$((number / 2)) \
    --fleet=keys/$desk --connect quic/10.7.$number.1:7447 >$desk.log 2>&1 &
done
for number in 1 2 3; do
  sees desk-$number 3 free
done
echo "three stations see each other over the router"

token=$("$PROGRAM" token --data desk-2 add control peer)
at router "$PYTHON" "$here/peer.py" quic/127.0.0.1:7447 keys/peer desk-2 "$token"
sees desk-1 1 'stopped by fleet: by a peer in Python'
sees desk-3 2 free
echo "a peer in Python read all states, and stopped desk-2"

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

# Without a router: a station that finds others by multicast, one beside it that is for its own machine, and at the other end of the
# cable somebody without a certificate, to whom both could connect.
"$PROGRAM" fleet certificates keys alone=10.7.1.2 >/dev/null
ip -n desk-1 route add 224.0.0.0/4 dev out
mkfifo ends
at router "$PYTHON" "$here/stranger.py" tcp/10.7.1.1:9999 to1 alone <ends >stranger.log 2>&1 &
stranger=$!
exec {ends}>ends
for name in alone loopback; do
  fleet=--fleet
  [[ $name == loopback ]] || fleet+==keys/$name
  # Do not inherit the pipe: the stranger ends when all of its writers have closed it.
  at $name "$PROGRAM" up --virtual --raw off --no-open --name $name --http 127.0.0.1:0 $fleet {ends}>&- >$name.log 2>&1 &
done
sees loopback 1 free
at router "$PYTHON" "$here/stranger.py" quic/10.7.1.1:0 to1 alone keys/peer
for name in alone loopback; do
  sees $name 1 free
done
exec {ends}>&-
wait $stranger || { cat stranger.log >&2; exit 1; }
echo "without a certificate nobody is connected to the stations on his network, and with one they are found"
