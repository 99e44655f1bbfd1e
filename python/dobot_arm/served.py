"""Virtual arms for programs that speak serial."""

from __future__ import annotations

import os
from collections.abc import Sequence
from types import TracebackType

from . import _core
from .errors import Failed
from .place import listed, scene
from .world import World


class Served:
    """A virtual arm on a serial port and on TCP, as a ``with`` lasts: what speaks to a real arm can speak to it.

    No rules are between the program and this arm. It serves one program at a time, at 9600 baud.
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
        """The name of its serial port, as ``/dev/pts/3``; Windows has none."""
        if self._served.serial is None:
            raise Failed("this system has no virtual serial ports", hint="`tcp` is the same arm")
        return self._served.serial

    @property
    def tcp(self) -> str:
        """Its address, as ``tcp:127.0.0.1:40123``."""
        return self._served.tcp

    @property
    def events(self) -> list[str]:
        """What its controller refused and which faults struck, each a sentence, the oldest first."""
        return self._served.events

    @property
    def world(self) -> World:
        """What is around it now."""
        told = self._served.world()
        if told is None:
            raise Failed("nothing is around this virtual arm", hint="`world=` says what is")
        return World._of(told)

    def close(self) -> None:
        """Switches it off; leaving ``with`` does it, too."""
        self._served.close()


def serve(
    personality: str = "firmware-1.1",
    *,
    world: str | os.PathLike[str] | None = None,
    faults: Sequence[str] = (),
    seed: int = 0,
    speed: float | str = 1.0,
) -> Served:
    """Serves a virtual arm to programs that speak serial, also to those that know nothing of this package.

    ``world``, ``faults`` and ``seed`` are as in :func:`connect`. ``speed`` is how many times as fast as a clock it
    lives, 0.1 to 1000, or ``"max"``: time runs on to the next status and waits for the program's answer, for a millisecond at most.
    """
    return Served(_core.Served(personality, scene(world), listed(faults), seed, str(speed)))
