"""An arm with blocking calls."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from types import TracebackType
from typing import Any

from . import place
from ._core import Statuses
from .errors import Error
from .operations import Operation, Button, Connection
from .status import Status
from .world import Object, Stroke

class Arm(Connection):
    """An arm. Threads may share it; a fork of the process may not use it."""

    def __enter__(self) -> Arm:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()


    @staticmethod
    def _calling(begin: Callable[..., Operation[Any]]) -> Callable[..., Any]:
        def call(self: Arm, *args: Any, **options: Any) -> Any:
            begun = begin(self, *args, **options)
            return begun.read(begun.pending.wait(begun.progress))

        return call

    def _last(self) -> Status:
        return super()._last() if self._core.last_status() else self.next_status()

    @property
    def ink(self) -> list[Stroke]:
        """The lines of ink under a virtual arm of this process: x and y in the base frame, in mm."""
        return self.world().ink

    @property
    def objects(self) -> dict[str, Object]:
        """The objects around a virtual arm of this process, by name."""
        return self.world().objects

    def jog(self, button: Button, speed: float = 50.0, *, at_most: float = 10.0) -> Jog:
        """Holds a button while a ``with`` block runs, at ``speed`` percent.

        The button is released at the end of the block, when the program ends or hangs, and after ``at_most``
        seconds (0.02 to 60), which raises :class:`Failed` at the end of the block. ``arm.wait(...)`` and
        ``arm.statuses()`` can be used in the block.
        """
        return Jog(self, button, speed, at_most)

    def statuses(self) -> Iterator[Status]:
        """Yields all statuses from now on, also while another thread moves the arm."""
        return _each(self._core.statuses())

    def close(self) -> None:
        """Disconnects from the arm; also called at the end of ``with``."""
        self._core.close()


def _each(statuses: Statuses) -> Iterator[Status]:
    while True:
        yield Status(**statuses.next())


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
) -> Arm:
    """Connects to an arm.

    ``virtual:`` or ``virtual:firmware-1.1`` is a virtual arm in this process, ``station`` the arm of the
    station on this machine, ``http://127.0.0.1:8642`` that of another station; with ``serial:/dev/ttyUSB0`` or
    ``tcp:host:port`` the rules are applied in this process, with the program ``dobot`` as the watchdog,
    which a wheel of a release contains.

    ``name`` is shown to other clients (default: the name of the script's file); ``token`` is required for more
    than watching (default: the environment variable ``DOBOT_TOKEN``, then the token of this user's station);
    ``dialect`` is the protocol dialect of an arm at an address, ``specification`` or ``firmware-1.1``. The certificate of a station at ``https://`` is
    checked with ``fingerprint``, its SHA-256 digest, which the station prints at its start; or with ``ca``, a
    PEM file of the issuer.

    A virtual arm of this process may have a ``world`` (a scene file that ends in ``.toml``, or the text of one)
    and ``faults`` such as ``drop=1%`` or ``zero=fore:2``; ``seed`` is their random seed.

    Raises :class:`LinkLost` if nothing responds, :class:`Refused` if a station refuses access,
    :class:`ValueError` for an invalid value.
    """
    core = place.connect(where, name, token, dialect, fingerprint, ca, world, faults, seed)
    core.connected().wait(None)
    return Arm(core, where)


class Jog:
    """A jog button that is held while a ``with`` block runs."""

    def __init__(self, arm: Arm, button: Button, speed: float, at_most: float) -> None:
        self._arm = arm
        self._press = (button, speed, at_most)

    def __enter__(self) -> None:
        try:
            self._arm._core.press(*self._press).wait(None)
        except KeyboardInterrupt:
            self._release_quietly()
            raise

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if error is None:
            self._arm._core.release().wait(None)
        else:
            self._release_quietly()

    def _release_quietly(self) -> None:
        """What went wrong before is what counts."""
        try:
            self._arm._core.release().wait(None)
        except Error:
            pass
