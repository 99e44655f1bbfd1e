"""The original Dobot Arm (2016), under the same rules as everything that moves it.

Points are millimetres in the base frame (x forward, y left, z up from the pivot of the rear arm), angles
are degrees.
"""

from __future__ import annotations

import shutil

from ._core import Core
from .aio import AsyncArm, AsyncJog, _over
from .arm import Arm, Jog
from .drawing import Plan, Progress, bar, plan
from .errors import Closed, Error, Failed, LinkLost, Refused, Stopped
from .operations import Button, Path
from .status import Status

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
    core = _core(where, name, token, dialect)
    core.connected().wait(None)
    return Arm(core)


async def aconnect(
    where: str, *, name: str = "python", token: str | None = None, dialect: str | None = None
) -> AsyncArm:
    """Connects with an arm for coroutines; otherwise as :func:`connect`."""
    core = _core(where, name, token, dialect)
    await _over(core.connected())
    return AsyncArm(core)


def _core(where: str, name: str, token: str | None, dialect: str | None) -> Core:
    guardian = None
    if where.startswith(("serial:", "tcp:")):
        guardian = shutil.which("dobot")
        if guardian is None:
            raise Failed(
                "nothing guards the arm: the program `dobot` is not in the search path",
                hint="install it, or start a station with it (`dobot up`) and connect with `station`",
            )
    return Core(where, name, token, dialect, guardian)
