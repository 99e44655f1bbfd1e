"""Addresses of arms."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence

from ._core import Core
from .errors import Failed


def connect(
    where: str,
    name: str | None,
    token: str | None,
    dialect: str | None,
    fingerprint: str | None,
    ca: str | os.PathLike[str] | None,
    world: str | os.PathLike[str] | None,
    faults: Sequence[str],
    seed: int,
) -> Core:
    """Begins to connect to an arm, with the arguments of :func:`dobot_arm.connect`."""
    if not 0 <= seed < 2**64:
        raise ValueError(f"seed is {seed}; allowed are 0 to 2**64 - 1")
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

    found = installed_program() or shutil.which("dobot")
    if found is None:
        raise Failed(
            "there is no watchdog for the arm: the program `dobot` is neither in this package nor in the search path",
            hint="install a wheel of a release, which contains it, or the program itself; or start a station with it "
            "(`dobot up`) and connect with `station`",
        )
    return found


def installed_program() -> str | None:
    """Returns the program that was installed with this package, wherever it was put."""
    from importlib.metadata import PackageNotFoundError, files

    try:
        found = files("dobot-arm") or []
    except PackageNotFoundError:
        return None
    programs = (str(file.locate()) for file in found if file.name in ("dobot", "dobot.exe"))
    return next((program for program in programs if os.path.isfile(program)), None)
