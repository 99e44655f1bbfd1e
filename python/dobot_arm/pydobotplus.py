"""The names of ``pydobotplus``: ``from dobot_arm.pydobotplus import Dobot``."""

from __future__ import annotations

from . import pydobot
from .pydobot import MODE_PTP, CustomPosition, Joints, Pose, Position

__all__ = ["MODE_PTP", "CustomPosition", "Dobot", "Joints", "Pose", "Position"]


class Dobot(pydobot.Dobot):
    """Like :class:`dobot_arm.pydobot.Dobot`, but moves turn all joints together and return when the arm has
    arrived.
    """

    def move_to(
        self,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
        r: float | None = 0,
        wait: bool = True,
        mode: int | None = None,
        position: CustomPosition | None = None,
    ) -> int:
        """Moves to a point with all joints together, or as ``mode`` says."""
        return super().move_to(x, y, z, r, wait, MODE_PTP.MOVJ_XYZ if mode is None else mode, position)
