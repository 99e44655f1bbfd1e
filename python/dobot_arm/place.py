"""Where the arm is."""

from __future__ import annotations

from ._core import Core
from .errors import Failed


def core(where: str, name: str, token: str | None, dialect: str | None) -> Core:
    """Begins to connect, with what guards an arm at an address."""
    guardian = None
    if where.startswith(("serial:", "tcp:")):
        import shutil  # Only here: it takes as long to import as much of this package.

        guardian = shutil.which("dobot")
        if guardian is None:
            raise Failed(
                "nothing guards the arm: the program `dobot` is not in the search path",
                hint="install it, or start a station with it (`dobot up`) and connect with `station`",
            )
    return Core(where, name, token, dialect, guardian)
