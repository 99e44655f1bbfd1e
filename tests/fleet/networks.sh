# Four networks on this machine, for the classes beside it, which source this: one for each of three desks, and one for the router
# between them. It takes namespaces for networks: as root, or where the system lets a user have some of his own.
#
# The desks are at 10.7.1.2, 10.7.2.2 and 10.7.3.2, the router at 10.7.1.1 and so on. Sourcing this starts the script again inside,
# in an empty folder that is removed at its end.

if [[ $(id -u) != 0 ]]; then
  exec unshare --user --map-root-user --net --mount "$0" "$@"
fi
# The names of the namespaces are this run's own.
if [[ -z ${DOBOT_CLASS:-} ]]; then
  DOBOT_CLASS=1 exec unshare --mount --pid --fork --kill-child "$0" "$@"
fi
mount -t tmpfs tmpfs /run
mount -t proc proc /proc
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
# The authority of this person's stations on this machine is this run's own, too.
export XDG_DATA_HOME=$work/home

# The networks, and a certificate for each in `keys`, made by this program.
make_networks() {
  local program=$1 number desk
  "$program" fleet certificates keys desk-1=10.7.1.2 desk-2=10.7.2.2 desk-3=10.7.3.2 \
    router=127.0.0.1,10.7.1.1,10.7.2.1,10.7.3.1 peer=10.7.1.1 >/dev/null
  ip netns add router
  ip -n router link set lo up
  for number in 1 2 3; do
    desk=desk-$number
    ip netns add $desk
    ip -n $desk link set lo up
    ip link add out netns $desk type veth peer name to$number netns router
    ip -n $desk addr add 10.7.$number.2/24 dev out
    ip -n $desk link set out up
    ip -n router addr add 10.7.$number.1/24 dev to$number
    ip -n router link set to$number up
  done
}
