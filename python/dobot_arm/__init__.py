"""The original Dobot Arm (2016), under the same rules as everything that moves it.

Points are millimetres in the base frame (x forward, y left, z up from the pivot of the rear arm), angles
are degrees.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .arm import Arm, Jog
from .drawing import Plan, Progress, bar, plan
from .errors import Closed, Error, Failed, LinkLost, Refused, Stopped
from .operations import Button, Path
from .place import core
from .status import Status

if TYPE_CHECKING:
    from .aio import AsyncArm, AsyncJog, aconnect

__all__ = [
    "Arm", "AsyncArm", "AsyncJog", "Button", "Closed", "Error", "Failed", "Jog", "LinkLost", "Path", "Plan",
    "Progress", "Refused", "Status", "Stopped", "aconnect", "bar", "connect", "plan",
]


def connect(
    where: str, *, name: str = "python", token: str | None = None, dialect: str | None = None
) -> Arm:
    """Connects with an arm.

    ``virtual:`` or ``virtual:firmware-1.1`` is a virtual one in this process, ``station`` that of the station
    that runs on this machine, ``http://127.0.0.1:8642`` that of the station there; ``serial:/dev/ttyUSB0`` or
    ``tcp:host:port`` is one whose rules are kept in this process, guarded by the program ``dobot``, which has
    to be installed.

    ``name`` is what others see; ``token`` allows more than watching (default: the environment variable
    ``DOBOT_TOKEN``, then that of the station of this person); ``dialect`` is what an arm at an address
    understands, ``specification`` or ``firmware-1.1``. Raises :class:`LinkLost` where nothing answers.
    """
    found = core(where, name, token, dialect)
    found.connected().wait(None)
    return Arm(found)


def __getattr__(name: str) -> object:
    """What is for coroutines is loaded when it is asked for: asyncio takes longer than all the rest."""
    if name in ("AsyncArm", "AsyncJog", "aconnect"):
        from . import aio

        return getattr(aio, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
