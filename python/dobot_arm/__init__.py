"""The original Dobot Arm (2016), under the same rules as everything that moves it.

Points are millimetres in the base frame (x forward, y left, z up from the pivot of the rear arm), angles
are degrees.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from types import TracebackType
from typing import Literal

from ._core import Core
from .drawing import Plan, Progress, bar, plan
from .errors import Closed, Error, Failed, LinkLost, Refused, Stopped

__all__ = [
    "Arm", "Closed", "Error", "Failed", "LinkLost", "Path", "Plan", "Progress", "Refused", "Status",
    "Stopped", "connect", "plan",
]

Path = Literal["jump", "movl", "movj"]
"""The way there: lift, across and down; in a straight line; all joints at once."""


@dataclass(frozen=True)
class Status:
    """Where the arm is and what its tool does, in millimetres and degrees."""

    x_mm: float
    y_mm: float
    z_mm: float
    rotation_deg: float
    base_deg: float
    rear_deg: float
    fore_deg: float
    servo_deg: float
    suction: bool
    gripper_deg: float


class Arm:
    """An arm. Threads may share it; a fork of the process may not use it."""

    def __init__(self, core: Core) -> None:
        self._core = core

    def __enter__(self) -> Arm:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def status(self) -> Status:
        """What the arm tells next."""
        return Status(**self._core.status())

    @property
    def pose(self) -> Status:
        """Where the tool is, in millimetres: ``x_mm``, ``y_mm``, ``z_mm``, ``rotation_deg``."""
        return self.status()

    @property
    def joints(self) -> Status:
        """The joint angles, in degrees: ``base_deg``, ``rear_deg``, ``fore_deg``, ``servo_deg``."""
        return self.status()

    def move_to(
        self,
        x: float,
        y: float,
        z: float,
        r: float | None = None,
        *,
        path: Path = "jump",
        suction: bool | None = None,
        gripper: float | None = None,
        pause: float = 0.0,
    ) -> Status:
        """Goes to a point (mm) and waits until it has arrived.

        ``r`` is the tool's rotation in the base frame and ``gripper`` the gripper's angle (degrees);
        ``suction`` is switched once there; ``pause`` is how long to wait there (seconds). What is left
        out stays as it is. Raises :class:`Refused` where the rules do not allow it, :class:`Stopped`
        where somebody stops the arm through this object. Ctrl-C stops the arm.
        """
        return Status(**self._core.move_to((x, y, z), r, path, suction, gripper, pause))

    def move_joints(
        self,
        base: float,
        rear: float,
        fore: float,
        servo: float | None = None,
        *,
        path: Path = "jump",
        suction: bool | None = None,
        gripper: float | None = None,
        pause: float = 0.0,
    ) -> Status:
        """Goes to joint angles (degrees) and waits until it has arrived; otherwise as :meth:`move_to`."""
        joints = (base, rear, fore)
        return Status(**self._core.move_joints(joints, servo, path, suction, gripper, pause))

    def suction(self, on: bool) -> None:
        """Switches the pump where the arm is."""
        self._core.suction(on)

    def draw(self, plan: Plan, *, progress: Progress | None = bar) -> None:
        """Draws it as a job and waits until that is over.

        The paper lies where the plan says (``pen_down``, ``paper``), else where a station knows it by
        calibration, else where the pen stands now. ``progress`` is called with how many commands of
        how many are over; what it raises stops the arm. Raises :class:`Failed` where the job is
        paused, cancelled or fails.
        """
        self._core.draw(plan._drawing, progress)

    def wait(self, seconds: float) -> None:
        """Lets time pass by the arm's clock."""
        self._core.wait(seconds)

    def stop(self, reason: str | None = None) -> None:
        """Stops the arm at once, whatever another thread has it do."""
        self._core.stop(reason)

    def reset_stop(self) -> None:
        """Lets the arm move again after a stop: a person has looked at it."""
        self._core.reset_stop()

    def confirm_pose(self) -> None:
        """Says that a person has looked: the arm stands where it says."""
        self._core.confirm_pose()

    def close(self) -> None:
        """Lets go of the arm; leaving ``with`` does it, too."""
        self._core.close()


def connect(where: str, *, name: str = "python", token: str | None = None) -> Arm:
    """Connects with an arm: ``virtual:``, ``virtual:firmware-1.1``, or a station as in
    ``http://127.0.0.1:8642``.

    ``name`` is what others see; ``token`` allows more than watching (default: the environment variable
    ``DOBOT_TOKEN``). Raises :class:`LinkLost` where no station answers.
    """
    return Arm(Core(where, name, token or os.environ.get("DOBOT_TOKEN") or None))
