"""The names of ``pydobotplus``: ``from dobot_arm.pydobotplus import Dobot``."""

from __future__ import annotations

from typing import NoReturn

from . import pydobot
from .errors import Error as DobotException
from .pydobot import MODE_PTP, CustomPosition, Joints, Pose, Position

__all__ = ["MODE_PTP", "CustomPosition", "Dobot", "DobotException", "Joints", "Pose", "Position"]

_JOG = 'hold a button with `with device.arm.jog("x+"): ...`'
_PORTS = "the arm of 2016 has no such port"
_MISSING = {
    "conveyor_belt": _PORTS,
    "conveyor_belt_distance": _PORTS,
    "engrave": "plan the picture with `dobot_arm.plan`, and draw it with `device.arm.draw`",
    "get_color": _PORTS,
    "get_hht_trig_output": _PORTS,
    "get_ir": _PORTS,
    "go_arc": "use the points of the arc with `device.arm.follow`",
    "jog_r": _JOG,
    "jog_x": _JOG,
    "jog_y": _JOG,
    "jog_z": _JOG,
    "set_color": _PORTS,
    "set_hht_trig_output": _PORTS,
    "set_io": _PORTS,
    "set_ir": _PORTS,
}
"""The methods of pydobotplus that are not here, and the remedy or the reason."""


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

    def move_rel(self, x: float = 0, y: float = 0, z: float = 0, r: float = 0, wait: bool = True) -> int:
        """Moves by a distance from the current position, with all joints together."""
        return super().move_to(x, y, z, r, wait, MODE_PTP.MOVJ_XYZ_INC)

    def __getattr__(self, name: str) -> NoReturn:
        reason = _MISSING.get(name)
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}" + (f": {reason}" if reason else ""))
