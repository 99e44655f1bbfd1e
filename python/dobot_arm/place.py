"""Addresses of arms."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from ._core import Core
from .errors import Failed


def connect(
    where: str,
    *,
    name: str | None = None,
    token: str | None = None,
    dialect: str | None = None,
    fingerprint: str | None = None,
    ca: str | os.PathLike[str] | None = None,
    world: str | os.PathLike[str] | None = None,
    faults: Sequence[str] = (),
    seed: int = 0,
) -> Core:
    """Connects to an arm.

    ``virtual:`` or ``virtual:firmware-1.1`` is a virtual arm in this process, ``station`` the arm of the
    station on this machine, ``http://127.0.0.1:8642`` that of another station; with ``serial:/dev/ttyUSB0`` or
    ``tcp:host:port`` the rules are applied in this process, with the program ``dobot`` as the watchdog, which
    must be installed.

    ``name`` is shown to other clients (default: the name of the script's file); ``token`` is required for more than watching (default: the environment
    variable ``DOBOT_TOKEN``, then the token of this user's station); ``dialect`` is the protocol dialect of an
    arm at an address, ``specification`` or ``firmware-1.1``. The certificate of a station at ``https://`` is
    checked with ``fingerprint``, its SHA-256 digest, which the station prints at its start; or with ``ca``, a
    PEM file of the issuer.

    A virtual arm of this process may have a ``world`` (a scene file that ends in ``.toml``, or the text of one)
    and ``faults`` such as ``drop=1%`` or ``zero=fore:2``; ``seed`` is their random seed.

    Raises :class:`LinkLost` if nothing responds, :class:`Refused` if a station refuses access,
    :class:`ValueError` for an invalid value.
    """
    return Core(
        where,
        {
            "name": name or script(), "token": token, "dialect": dialect, "watchdog": watchdog(where),
            "fingerprint": fingerprint, "ca": None if ca is None else os.fspath(ca),
            "world": scene(world), "faults": listed(faults), "seed": seed,
        },
    )


def script() -> str:
    """Returns the name of the file of the running script, or ``python`` if there is none."""
    file = os.path.basename(sys.argv[0]) if sys.argv else ""
    name = "".join(letter for letter in file if letter.isprintable()).strip()[:60]
    return name if name not in ("", "-c", "-m", "-") else "python"


def scene(world: str | os.PathLike[str] | None) -> str | None:
    """Returns the text of a scene, reading it if it is the name of a file."""
    if world is None or (isinstance(world, str) and not world.endswith(".toml")):
        return world
    with open(world, encoding="utf-8") as file:
        return file.read()


def listed(faults: Sequence[str]) -> list[str]:
    """Returns faults as a list."""
    if isinstance(faults, str):
        raise TypeError(f"faults is a string; allowed is a list of strings: [{faults!r}]")
    return list(faults)


def watchdog(where: str) -> str | None:
    """Returns the watchdog program for an arm at an address."""
    if not where.startswith(("serial:", "tcp:")):
        return None
    import shutil  # Imported here because it is slow to import.

    found = shutil.which("dobot")
    if found is None:
        raise Failed(
            "there is no watchdog for the arm: the program `dobot` is not in the search path",
            hint="install it, or start a station with it (`dobot up`) and connect with `station`",
        )
    return found
