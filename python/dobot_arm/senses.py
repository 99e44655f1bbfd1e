"""What the programs that move an arm by a sense share: their connections, and what they do when it is over."""

from __future__ import annotations

import argparse
from contextlib import ExitStack

from .arm import Arm, connect
from .errors import Error


def add_arm_options(parser: argparse.ArgumentParser) -> None:
    """Adds the options that name an arm."""
    parser.add_argument("--to", default="station", help="station (default), http://HOST:PORT, or an arm's address")
    parser.add_argument("--token", help="access token of a station; default: DOBOT_TOKEN, then that of this user's station")
    parser.add_argument("--fingerprint", help="SHA-256 digest of the certificate of a station at https://")


def is_station(to: str) -> bool:
    """Whether an address is that of a station."""
    return to == "station" or to.startswith(("http://", "https://"))


def connect_both(arguments: argparse.Namespace, moves: str, shows: str, until: ExitStack) -> tuple[Arm, Arm]:
    """The arm that moves and the one that shows and stops meanwhile, by these names; without a station they are the same."""

    def connected(name: str) -> Arm:
        return until.enter_context(connect(arguments.to, name=name, token=arguments.token, fingerprint=arguments.fingerprint))

    shown = connected(shows)
    return (connected(moves) if is_station(arguments.to) else shown), shown


def stop(arm: Arm, reason: str) -> None:
    """Stops the arm, and says whether that was possible."""
    try:
        arm.stop(reason)
        print("stop", flush=True)
    except Error as error:
        print(f"stop: {error}", flush=True)


def release(arm: Arm) -> None:
    """Lets others move the arm."""
    try:
        arm.release_control()
    except Error:
        pass  # Somebody else has taken it.
