"""Where the arm is."""

from __future__ import annotations

import os
from collections.abc import Sequence

from ._core import Core
from .errors import Failed


def connect(
    where: str,
    *,
    name: str = "python",
    token: str | None = None,
    dialect: str | None = None,
    fingerprint: str | None = None,
    ca: str | os.PathLike[str] | None = None,
    world: str | os.PathLike[str] | None = None,
    faults: Sequence[str] = (),
    seed: int = 0,
) -> Core:
    """Connects with an arm.

    ``virtual:`` or ``virtual:firmware-1.1`` is a virtual one in this process, ``station`` that of the station
    that runs on this machine, ``http://127.0.0.1:8642`` that of the station there; ``serial:/dev/ttyUSB0`` or
    ``tcp:host:port`` is one whose rules are kept in this process, guarded by the program ``dobot``, which has
    to be installed.

    ``name`` is what others see; ``token`` allows more than watching (default: the environment variable
    ``DOBOT_TOKEN``, then that of the station of this person); ``dialect`` is what an arm at an address
    understands, ``specification`` or ``firmware-1.1``. The certificate of a station at ``https://`` is trusted by
    ``fingerprint``, its SHA-256 digest, which the station tells at its start; or by ``ca``, a PEM file with who issued it.

    A virtual arm of this process may stand in a ``world`` (a scene file that ends in ``.toml``, or the text of one) and
    have ``faults`` such as ``drop=1%`` or ``zero=fore:2``; the same ``seed`` gives the same chances.

    Raises :class:`LinkLost` where nothing answers, :class:`Refused` where a station does not let it in,
    :class:`ValueError` for a value that is not allowed.
    """
    return Core(
        where,
        {
            "name": name, "token": token, "dialect": dialect, "watchdog": watchdog(where),
            "fingerprint": fingerprint, "ca": None if ca is None else os.fspath(ca),
            "world": scene(world), "faults": listed(faults), "seed": seed,
        },
    )


def scene(world: str | os.PathLike[str] | None) -> str | None:
    """The text of a scene: of a file, where it is the name of one."""
    if world is None or (isinstance(world, str) and not world.endswith(".toml")):
        return world
    with open(world, encoding="utf-8") as file:
        return file.read()


def listed(faults: Sequence[str]) -> list[str]:
    """Faults as a list."""
    if isinstance(faults, str):
        raise TypeError(f"faults is the text {faults!r}; allowed is a list of them: [{faults!r}]")
    return list(faults)


def watchdog(where: str) -> str | None:
    """The program that guards an arm at an address."""
    if not where.startswith(("serial:", "tcp:")):
        return None
    import shutil  # Only here: it takes as long to import as much of this package.

    found = shutil.which("dobot")
    if found is None:
        raise Failed(
            "nothing guards the arm: the program `dobot` is not in the search path",
            hint="install it, or start a station with it (`dobot up`) and connect with `station`",
        )
    return found
