"""Scripts in virtual time."""

from __future__ import annotations

import os

from ._core import Simulated
from .table import Table


class Simulation:
    """What came of a script. In a notebook it shows itself."""

    def __init__(self, simulated: Simulated) -> None:
        self._simulated = simulated

    @property
    def statuses(self) -> Table:
        """What the arm uploaded: ``at_s``, the place (mm), the angles (degrees), suction and gripper."""
        return Table(self._simulated.statuses())

    @property
    def ticks(self) -> Table:
        """Where the arm truly was at every control tick (20 ms): ``at_s``, the place (mm), the angles (degrees), motor
        pulses since power-up, pump and laser."""
        return Table(self._simulated.ticks())

    @property
    def refused(self) -> list[tuple[float, str]]:
        """What the controller refused: when, in seconds, and why."""
        return self._simulated.refused

    @property
    def unsent(self) -> int:
        """How many lines of the script were still to be sent when it ended."""
        return self._simulated.unsent

    @property
    def end_s(self) -> float:
        """When it ended, in seconds."""
        return self._simulated.end_s

    @property
    def other_port(self) -> str:
        """What the arm printed on the port that is not in use."""
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
    """Runs a script of packets in virtual time, without any rules: what would an arm do with them?

    A line is a packet, ``T f1 f2 ... f10``: T is when its first byte starts, in milliseconds, or ``credit`` for when
    the next status has arrived; the ten floats are those of the protocol. ``dobot simulate --help`` tells what else there is.

    Raises :class:`ValueError` with the line that is no script, :class:`OSError` where the file cannot be read.
    """
    if (file is None) == (text is None):
        raise TypeError("give a file or text=, and one of them only")
    if file is not None:
        with open(file, encoding="utf-8") as opened:
            text = opened.read()
    assert text is not None
    name = "script" if file is None else os.path.basename(os.fspath(file))
    return Simulation(Simulated(text, name, personality))
