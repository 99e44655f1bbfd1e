"""Scripts in virtual time."""

from __future__ import annotations

import os

from ._core import Simulated
from .table import Table


class Simulation:
    """The result of a script. Displays its picture in a notebook."""

    def __init__(self, simulated: Simulated) -> None:
        self._simulated = simulated

    @property
    def statuses(self) -> Table:
        """The uploaded statuses: ``at_s``, the position (mm), the angles (degrees), suction and gripper."""
        return Table(self._simulated.statuses())

    @property
    def ticks(self) -> Table:
        """The true state at every control tick (20 ms): ``at_s``, the position (mm), the angles (degrees),
        motor pulses since power-up, pump and laser.
        """
        return Table(self._simulated.ticks())

    @property
    def refused(self) -> list[tuple[float, str]]:
        """What the controller refused: the time in seconds, and the reason."""
        return self._simulated.refused

    @property
    def unsent(self) -> int:
        """How many lines of the script were still to be sent when it ended."""
        return self._simulated.unsent

    @property
    def end_s(self) -> float:
        """The time at its end, in seconds."""
        return self._simulated.end_s

    @property
    def other_port(self) -> str:
        """The output of the arm on the unused port."""
        return self._simulated.other_port

    def svg(self) -> str:
        """The way of the tool, angles and speeds as a picture (SVG)."""
        return self._simulated.svg()

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<Simulation: {self.end_s:.2f} s, {len(self.refused)} refused>"


def simulate(
    file: str | os.PathLike[str] | None = None, *, text: str | None = None, personality: str = "specification"
) -> Simulation:
    """Runs a script of packets in virtual time, without any rules.

    A line is a packet, ``T f1 f2 ... f10``: T is the time of its first byte in milliseconds, or ``credit`` for
    the arrival of the next status; the ten floats are those of the protocol. ``dobot simulate --help``
    describes the rest.

    Raises :class:`ValueError` with the invalid line, :class:`OSError` if the file cannot be read.
    """
    if (file is None) == (text is None):
        raise TypeError("give either a file or text=")
    if file is not None:
        with open(file, encoding="utf-8") as opened:
            text = opened.read()
    assert text is not None
    name = "script" if file is None else os.path.basename(os.fspath(file))
    return Simulation(Simulated(text, name, personality))
