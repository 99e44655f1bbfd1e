"""Recorded paths of an arm."""

from __future__ import annotations

from types import TracebackType

from ._core import Core, Statuses, Taught
from .programs import Program
from .status import Status


class Take:
    """The statuses of an arm during a ``with`` block, for a program that repeats its path."""

    def __init__(self, core: Core) -> None:
        self._core = core
        self._incoming: Statuses | None = None
        self._received: list[Status] = []

    def __enter__(self) -> Take:
        self._incoming = self._core.statuses()
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self._receive()
        self._incoming = None

    @property
    def statuses(self) -> list[Status]:
        """The statuses so far."""
        self._receive()
        return list(self._received)

    def program(self, title: str = "recorded", *, tolerance: float = 0.5) -> Program:
        """Returns a program of straight lines along the path, with the fewest points within ``tolerance`` mm (and
        degrees of the tool's rotation). Pump and gripper are switched where they were.
        """
        places = [
            ((status.x_mm, status.y_mm, status.z_mm), status.rotation_deg, status.suction, status.gripper_deg)
            for status in self.statuses
        ]
        if not places:
            raise ValueError("nothing was recorded: no status arrived during the `with` block")
        return Program(Taught.of_path(title, places, tolerance))

    def _receive(self) -> None:
        while self._incoming is not None and (fields := self._incoming.poll()) is not None:
            self._received.append(Status(**fields))

    def __repr__(self) -> str:
        return f"<Take: {len(self.statuses)} statuses>"
