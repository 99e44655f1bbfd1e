"""What is wrong with one arm, from points that its tool has touched."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import Literal

from ._core import Calibrated, sheet_points
from .status import Status

SHEET: tuple[tuple[float, float], ...] = tuple(sheet_points())
"""The points of the printed sheet, in the order in which they are touched: x and y in mm."""


@dataclass(frozen=True)
class Touch:
    """A known point, and what the arm told when its tool touched it."""

    x_mm: float
    """Where it truly is: forward of the base's axis."""
    y_mm: float
    """Where it truly is: to the left."""
    status: Status
    """What the arm told; of an arm that no calibration holds for."""
    height_mm: float = 0.0
    """How high above the paper it is: 0 on the paper itself."""


class Calibration:
    """What is wrong with an arm. In a notebook it shows its touches."""

    def __init__(self, calibrated: Calibrated) -> None:
        self._calibrated = calibrated

    @property
    def zeros_deg(self) -> tuple[float, float, float]:
        """How much further base, rear arm and forearm stand than the arm says, in degrees."""
        return self._calibrated.zeros_deg

    @property
    def tool_mm(self) -> tuple[float, float]:
        """How much further out and to the left the tool is than drawn, in mm."""
        return self._calibrated.tool_mm

    @property
    def residuals_mm(self) -> list[float]:
        """How far each touch is from where it should be, in mm."""
        return self._calibrated.residuals_mm

    @property
    def typical_mm(self) -> float:
        """The root of the mean square of the residuals that count, in mm."""
        return self._calibrated.typical_mm

    @property
    def expected_mm(self) -> float:
        """How wrong a place on the sheet may still be, typically, in mm."""
        return self._calibrated.expected_mm

    @property
    def left_out(self) -> int | None:
        """The touch that contradicts all others and was left out, counted from 0."""
        return self._calibrated.left_out

    @property
    def trust(self) -> Literal["good", "unchecked", "doubtful"]:
        """Whether to use it: ``unchecked`` touches are so few that a wrong one would not be noticed."""
        return self._calibrated.trust

    @property
    def text(self) -> str:
        """The text of a file for ``dobot calibrate FILE --use``, from when on it holds for that arm."""
        return self._calibrated.text

    def told_place(self, x: float, y: float, z: float) -> tuple[float, float, float]:
        """The place that the arm has to be told for its tool to be at a true one, in mm.

        Raises :class:`ValueError` where the arm cannot bring its tool there.
        """
        return self._calibrated.told_place(x, y, z)

    def true_place(self, x: float, y: float, z: float) -> tuple[float, float, float]:
        """Where the tool is when the arm says this place, in mm."""
        return self._calibrated.true_place(x, y, z)

    def svg(self) -> str:
        """The touches, and where the calibration has them (SVG)."""
        return self._calibrated.svg()

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        base, rear, fore = self.zeros_deg
        return f"<Calibration: {self.trust}, zeros {base:.2f}, {rear:.2f}, {fore:.2f} degrees, typically {self.typical_mm:.2f} mm off>"


def calibrate(touches: Iterable[Touch]) -> Calibration:
    """Finds what is wrong with an arm whose tool has touched known points: four at least, better nine.

    Raises :class:`ValueError` where they tell too little, contradict each other, or tell of what no arm has.
    """
    told = [(it.x_mm, it.y_mm, it.height_mm, it.status.base_deg, it.status.rear_deg, it.status.fore_deg) for it in touches]
    return Calibration(Calibrated(told))
