"""Calibration of an arm, from points that its tool has touched."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from ._core import Calibrated, sheet_points
from .status import Status

SHEET: tuple[tuple[float, float], ...] = tuple(sheet_points())
"""The points of the printed sheet, in the order of touching: x and y in mm."""


@dataclass(frozen=True)
class Touch:
    """A known point, and the reported status when the tool touched it."""

    x_mm: float
    """The true position: forward of the base's axis."""
    y_mm: float
    """The true position: to the left."""
    status: Status
    """The reported status, of an arm without an active calibration."""
    height_mm: float = 0.0
    """The height above the paper: 0 on the paper itself."""


class Calibration:
    """A calibration of an arm. Displays its touches in a notebook."""

    def __init__(self, calibrated: Calibrated) -> None:
        self._calibrated = calibrated

    @property
    def zeros_deg(self) -> tuple[float, float, float]:
        """The zero offsets of base, rear arm and forearm: true minus reported angle, in degrees."""
        return self._calibrated.zeros_deg

    @property
    def tool_mm(self) -> tuple[float, float]:
        """The offset of the tool outward and to the left of its nominal position, in mm."""
        return self._calibrated.tool_mm

    @property
    def residuals_mm(self) -> list[float]:
        """The residual of each touch, in mm."""
        return self._calibrated.residuals_mm

    @property
    def typical_mm(self) -> float:
        """The root mean square of the used residuals, in mm."""
        return self._calibrated.typical_mm

    @property
    def expected_mm(self) -> float:
        """The typical remaining error of a position on the sheet, in mm."""
        return self._calibrated.expected_mm

    @property
    def wrong(self) -> list[int]:
        """The touches that were left out because they contradict all others, counted from 0."""
        return self._calibrated.wrong

    @property
    def left_out(self) -> int | None:
        """The first of :attr:`wrong`; deprecated."""
        return next(iter(self.wrong), None)

    @property
    def trust(self) -> Literal["good", "unchecked", "unmeasured", "doubtful"]:
        """Whether to use it.

        ``unchecked`` means too few touches to detect a wrong one; ``unmeasured`` means that the tool is more than
        8 mm from its nominal position: measure it, and the print, and pass ``tool_measured=True``.
        """
        return self._calibrated.trust

    @property
    def text(self) -> str:
        """The text of a file for ``dobot calibrate FILE --use``, which makes it active for that arm."""
        return self._calibrated.text

    def raw_place(self, x: float, y: float, z: float) -> tuple[float, float, float]:
        """The raw position to command for a calibrated position of the tool, in mm.

        Raises :class:`ValueError` if the tool cannot reach it.
        """
        return self._calibrated.raw_place(x, y, z)

    def true_place(self, x: float, y: float, z: float) -> tuple[float, float, float]:
        """The calibrated position for a raw position, in mm."""
        return self._calibrated.true_place(x, y, z)

    def svg(self) -> str:
        """A picture of the touches and their residuals (SVG)."""
        return self._calibrated.svg()

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        base, rear, fore = self.zeros_deg
        return f"<Calibration: {self.trust}, zeros {base:.2f}, {rear:.2f}, {fore:.2f} degrees, typically {self.typical_mm:.2f} mm off>"


def calibrate(touches: Iterable[Touch], *, tool_measured: bool = False) -> Calibration:
    """Fits a calibration to touches of known points: at least four, better nine.

    ``tool_measured`` states that a person has measured the tool and found it off by
    :attr:`Calibration.tool_mm`.

    Raises :class:`ValueError` if the touches are insufficient, contradict each other, or give values that are
    not plausible.
    """
    points = [(touch.x_mm, touch.y_mm, touch.height_mm, touch.status.base_deg, touch.status.rear_deg, touch.status.fore_deg) for touch in touches]
    return Calibration(Calibrated(points, tool_measured))
