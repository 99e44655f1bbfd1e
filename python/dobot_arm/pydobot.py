"""The names of ``pydobot``, for scripts written for it: ``from dobot_arm.pydobot import Dobot``.

Positions are those of this arm: z is measured from the pivot of the rear arm, and the arm has no homing.
"""

from __future__ import annotations

import math
import os
import warnings
from enum import IntEnum
from types import TracebackType
from typing import NamedTuple

from ._core import Pending
from .arm import Arm, connect

__all__ = ["MODE_PTP", "CustomPosition", "Dobot", "Joints", "PTPMode", "Pose", "Position"]


class PTPMode(IntEnum):
    """The ways to move: a jump, all joints together (MOVJ) or straight (MOVL), to a point, to joint angles, or by
    a distance.
    """

    JUMP_XYZ = 0
    MOVJ_XYZ = 1
    MOVL_XYZ = 2
    JUMP_ANGLE = 3
    MOVJ_ANGLE = 4
    MOVL_ANGLE = 5
    MOVJ_INC = 6
    MOVL_INC = 7
    MOVJ_XYZ_INC = 8
    JUMP_MOVL_XYZ = 9


MODE_PTP = PTPMode


class CustomPosition:
    """A position of ``move_to(position=...)``, in mm and degrees."""

    def __init__(
        self, x: float | None = None, y: float | None = None, z: float | None = None, r: float | None = None
    ) -> None:
        self.x = x
        self.y = y
        self.z = z
        self.r = r


class Position(NamedTuple):
    """A position in mm, and the rotation of the tool in degrees."""

    x: float
    y: float
    z: float
    r: float


class Joints(NamedTuple):
    """Joint angles in degrees: base, rear arm, forearm, servo."""

    j1: float
    j2: float
    j3: float
    j4: float

    def in_radians(self) -> Joints:
        """Returns the angles in radians."""
        return Joints(*map(math.radians, self))


class Pose(NamedTuple):
    """A position and its joint angles."""

    position: Position
    joints: Joints


class Dobot:
    """An arm with the methods of pydobot.

    ``port`` is an address of :func:`dobot_arm.connect`, such as ``virtual:firmware-1.1``. For the name of a port,
    such as ``/dev/ttyUSB0`` or ``COM4``, the arm is that of the environment variable ``DOBOT_ARM``, or that of the
    station on this machine, which has opened the port.

    A move without ``wait`` returns when it has begun. The next call that needs the arm waits for it, and raises its
    error before anything else moves.
    """

    arm: Arm
    """The arm itself, with all its methods."""
    x: float
    """Of the last :meth:`pose`, like ``y``, ``z``, ``r`` and ``j1`` to ``j4``."""
    y: float
    z: float
    r: float
    j1: float
    j2: float
    j3: float
    j4: float

    def __init__(self, port: str | None = None, verbose: bool = False) -> None:
        address = port if port is not None and ":" in port or port == "station" else os.environ.get("DOBOT_ARM", "station")
        assert address is not None
        self.verbose = verbose
        self.arm = connect(address, name="pydobot")
        self._begun: Pending | None = None
        self._moves = 0
        self._home = Position(*self.pose()[:4])
        self.arm.set_moves(
            joint_speed=200, joint_acceleration=200, servo_speed=200, servo_acceleration=200,
            linear_speed=200, linear_acceleration=200, jump_height=10,
        )
        self.arm.speed(100, 100)
        self._say(f"{address} open")

    def close(self) -> None:
        """Waits for all moves, and disconnects."""
        try:
            self._finish()
        finally:
            self.arm.close()
            self._say("closed")

    def __enter__(self) -> Dobot:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if error is None:
            self.close()
        else:
            self.arm.close()

    def move_to(
        self,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
        r: float | None = None,
        wait: bool = False,
        mode: int | None = None,
        position: CustomPosition | None = None,
    ) -> int:
        """Moves straight to a point, or as ``mode`` says. Omitted values do not change."""
        return self._move(x, y, z, r, wait, PTPMode.MOVL_XYZ if mode is None else PTPMode(mode), position)

    def move_rel(self, x: float = 0, y: float = 0, z: float = 0, r: float = 0, wait: bool = True) -> int:
        """Moves by a distance from the current position."""
        return self._move(x, y, z, r, wait, PTPMode.MOVL_INC, None)

    def go(self, x: float, y: float, z: float, r: float = 0.0) -> int:
        """The old name of :meth:`move_to`."""
        warnings.warn("go() is deprecated, use move_to() instead", stacklevel=2)
        return self.move_to(x, y, z, r)

    def _move(
        self,
        x: float | None,
        y: float | None,
        z: float | None,
        r: float | None,
        wait: bool,
        mode: PTPMode,
        position: CustomPosition | None,
    ) -> int:
        if position is not None:
            x, y, z, r = position.x, position.y, position.z, position.r
        self._finish()
        path = "jump" if mode.name.startswith("JUMP") else mode.name[:4].lower()
        how = (path, None, None, 0.0)
        if mode.name.endswith("ANGLE"):
            self._begun = self.arm._core.move_joints((x, y, z, r), how)
        elif mode == PTPMode.MOVJ_INC:
            base, rear, fore, servo = (angle + (by or 0.0) for angle, by in zip(self.arm.joints, (x, y, z, r)))
            self._begun = self.arm._core.move_joints((base, rear, fore, servo), how)
        elif mode.name.endswith("INC"):
            self._begun = self.arm._core.move_to("current", (x, y, z, r), how)
        else:
            self._begun = self.arm._core.move_to("base", (x, y, z, r), how)
        self._say(f"{mode.name} {x} {y} {z} {r}")
        if wait:
            self._finish()
        self._moves += 1
        return self._moves

    def suck(self, enable: bool) -> None:
        """Switches the suction cup's pump."""
        self._finish()
        self.arm.suction(enable)

    def grip(self, enable: bool) -> None:
        """Closes or opens the gripper: -90 or 90 degrees."""
        self._finish()
        self.arm.gripper(-90 if enable else 90)

    def speed(self, velocity: float = 100.0, acceleration: float = 100.0) -> None:
        """Sets speed and acceleration: of joints in percent, up to 100; along a line as well, of as many mm/s and
        mm/s2.
        """
        self._finish()
        self.arm.set_moves(
            joint_speed=200, joint_acceleration=200, servo_speed=200, servo_acceleration=200,
            linear_speed=velocity, linear_acceleration=acceleration, jump_height=10,
        )
        self.arm.speed(min(velocity, 100.0), min(acceleration, 100.0))

    def wait(self, ms: float) -> None:
        """Waits, in milliseconds, after the moves so far."""
        self._finish()
        self.arm.wait(ms / 1000)

    def pose(self) -> tuple[float, float, float, float, float, float, float, float]:
        """Returns x, y, z, r (mm and degrees) and the angles of base, rear arm, forearm and servo (degrees), also
        during a move.
        """
        self.x, self.y, self.z, self.r = self.arm.pose
        self.j1, self.j2, self.j3, self.j4 = self.arm.joints
        return self.x, self.y, self.z, self.r, self.j1, self.j2, self.j3, self.j4

    def get_pose(self) -> Pose:
        """Returns position and joint angles, also during a move."""
        return Pose(Position(*self.arm.pose), Joints(*self.arm.joints))

    def set_home(self, x: float, y: float, z: float, r: float = 0.0) -> None:
        """Sets the position of :meth:`home`."""
        self._home = Position(x, y, z, r)

    def home(self) -> None:
        """Moves to the position of :meth:`set_home`, or to that at the start. The arm has no homing."""
        self._move(*self._home, True, PTPMode.MOVJ_XYZ, None)

    def wait_for_cmd(self, cmd_id: int) -> None:
        """Waits for all moves."""
        self._finish()

    def get_alarms(self) -> set[int]:
        """Returns nothing: the arm has no alarms. What is wrong is an exception."""
        return set()

    def clear_alarms(self) -> None:
        """Does nothing: the arm has no alarms. Only a person resets a stop (``arm.reset_stop()``)."""

    def laze(self, power: float = 0, enable: bool = False) -> None:
        """Switches the laser. It must be armed (``arm.arm_laser``) and has one power."""
        self._finish()
        self.arm.laser(enable)

    def get_eio(self, addr: int) -> int:
        """Raises: the arm has no inputs."""
        raise NotImplementedError("the arm of 2016 has no inputs that a program can read")

    def set_eio(self, addr: int, val: int) -> None:
        """Raises: the arm has no outputs other than the pump, the gripper and the laser."""
        raise NotImplementedError("the arm of 2016 has no outputs that a program can set; use suck, grip and laze")

    def _finish(self) -> None:
        """Waits for the move that has begun."""
        begun, self._begun = self._begun, None
        if begun is not None:
            begun.wait(None)

    def _say(self, text: str) -> None:
        if self.verbose:
            print(f"pydobot: {text}")

    def __repr__(self) -> str:
        return f"<Dobot {self.arm!r}>"
