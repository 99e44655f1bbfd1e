"""A peer of a fleet that is none of ours: it reads the state of every station, and stops one.

    python peer.py ADDRESS FOLDER NAME TOKEN
"""

import json
import sys
from pathlib import Path

import zenoh

from credentials import tls_of

address, folder, name, token = sys.argv[1:]
config = zenoh.Config()
config.insert_json5("mode", '"client"')
config.insert_json5("connect/endpoints", json.dumps([address]))
config.insert_json5("scouting/multicast/enabled", "false")
tls_of(config, Path(folder), "connect")


def ask(session: zenoh.Session, request: dict[str, str | dict[str, str]]) -> tuple[int, object]:
    """What the station answers to a request of its own API."""
    replies = session.get(f"dobot/2/{name}/*/api", payload=json.dumps(request), timeout=10.0)
    answer = json.loads(next(iter(replies)).ok.payload.to_string())
    return answer["status"], answer["body"]


with zenoh.open(config) as session:
    alive = [str(reply.ok.key_expr) for reply in session.liveliness().get("dobot/alive/**", timeout=10.0)]
    names = sorted(key.split("/")[4] for key in alive)
    assert names == ["desk-1", "desk-2", "desk-3"], alive

    reported = [json.loads(reply.ok.payload.to_string()) for reply in session.get("dobot/2/*/*/state", timeout=10.0)]
    assert len(reported) == 3, reported
    for one in reported:
        assert one["state"]["link"]["phase"] == "up", one
        assert abs(one["state"]["arm"]["x_mm"]) < 400, one

    # Whoever belongs to the fleet may look and stop. All else is for requests that only the station can read.
    lease: dict[str, str | dict[str, str]] = {"method": "POST", "path": "/api/v1/lease"}
    for request in (lease, lease | {"token": token}):
        status, body = ask(session, request)
        assert status == 403, (status, body)
    stop: dict[str, str | dict[str, str]] = {"method": "POST", "path": "/api/v1/stop", "body": {"reason": "by a peer in Python"}}
    status, body = ask(session, stop)
    assert status == 200, (status, body)
