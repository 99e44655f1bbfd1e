"""One on the same network as the stations, which find each other by multicast: with a certificate it has to find a station, and
without one nobody.

    python stranger.py LISTEN INTERFACE NAME [FOLDER]

With FOLDER it ends as soon as it sees the station NAME, and fails if it sees others. Without, it listens and looks until its
standard input ends, and fails if it was ever connected to anybody, or saw anything.
"""

import json
import sys
import time
from pathlib import Path

import zenoh

from credentials import tls_of

listen, interface, name, *folder = sys.argv[1:]
config = zenoh.Config()
config.insert_json5("mode", '"peer"')
config.insert_json5("listen/endpoints", json.dumps([listen]))
config.insert_json5("scouting/multicast/enabled", "true")
config.insert_json5("scouting/multicast/interface", json.dumps(interface))
if folder:
    tls_of(config, Path(folder[0]), "listen", "connect")


def seen(session: zenoh.Session) -> list[str]:
    """The names of the stations that are there."""
    replies = session.liveliness().get("dobot/alive/**", timeout=1.0)
    return sorted(str(reply.ok.key_expr).split("/")[4] for reply in replies)


with zenoh.open(config) as session:
    if folder:
        end = time.monotonic() + 60
        while (names := seen(session)) != [name]:
            assert not names, names
            assert time.monotonic() < end, f"{name} was not found"
            time.sleep(0.2)
        print(f"{name} is found with a certificate")
    else:
        received: list[str] = []
        for key in ("dobot/**", "dobot/*/*/*/reported"):
            session.declare_subscriber(key, lambda sample: received.append(str(sample.key_expr)))
        session.declare_queryable("dobot/**", lambda query: received.append(str(query.key_expr)))
        sys.stdin.read()
        peers = list(session.info.peers_zid()) + list(session.info.routers_zid())
        assert not peers, peers
        assert not seen(session)
        assert not received, received
        stop = json.dumps({"method": "POST", "path": "/api/v1/stop"})
        assert not list(session.get("dobot/*/*/*/api", payload=stop, timeout=1.0))
