"""Virtual arms for programs that use a serial port."""

from __future__ import annotations

import os
from collections.abc import Sequence
from types import TracebackType

from . import _core
from .errors import Failed
from .place import listed, scene
from .world import World


class Served:
    """A virtual arm on a serial port and on TCP, for the duration of a ``with`` block: any program for a real
    arm can use it.

    There are no safety rules between the program and this arm. It serves one program at a time, at 9600 baud.
    """

    def __init__(self, served: _core.Served) -> None:
        self._served = served

    def __enter__(self) -> Served:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    @property
    def serial(self) -> str:
        """The path of its serial port, such as ``/dev/pts/3``; not available on Windows."""
        if self._served.serial is None:
            raise Failed("this system has no virtual serial ports", hint="use `tcp`, which is the same arm")
        return self._served.serial

    @property
    def tcp(self) -> str:
        """Its address, such as ``tcp:127.0.0.1:40123``."""
        return self._served.tcp

    @property
    def events(self) -> list[str]:
        """What its controller refused and which faults occurred, a sentence each, the oldest first."""
        return self._served.events

    @property
    def world(self) -> World:
        """Its current world."""
        world = self._served.world()
        if world is None:
            raise Failed("this virtual arm has no world", hint="set it with `world=`")
        return World._of(world)

    def close(self) -> None:
        """Switches it off; also called at the end of ``with``."""
        self._served.close()


def serve(
    personality: str = "firmware-1.1",
    *,
    world: str | os.PathLike[str] | None = None,
    faults: Sequence[str] = (),
    seed: int = 0,
    speed: float | str = 1.0,
) -> Served:
    """Serves a virtual arm to programs that use a serial port, also to those without this package.

    ``world``, ``faults`` and ``seed`` are as in :func:`connect`. ``speed`` is the simulation speed, 0.1 to 1000
    times real time, or ``"max"``: time advances to the next status and then waits at most a millisecond for the
    program's response.
    """
    return Served(_core.Served(personality, scene(world), listed(faults), seed, str(speed)))
