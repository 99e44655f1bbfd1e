"""An arm with blocking calls."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import wraps
from types import TracebackType
from typing import Concatenate, ParamSpec, TypeVar

from . import operations, place
from ._core import Core
from .errors import Error
from .operations import Operation, Button, Connection
from .status import Status
from .world import Object, Stroke

P = ParamSpec("P")
T = TypeVar("T")


def _waiting(
    begin: Callable[Concatenate[Connection, P], Operation[T]],
) -> Callable[Concatenate[Connection, P], T]:
    """The operation, as a call that waits for its end."""

    @wraps(begin)
    def call(arm: Connection, /, *args: P.args, **options: P.kwargs) -> T:
        begun = begin(arm, *args, **options)
        return begun.read(begun.pending.wait(begun.progress))

    return call


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

    status = _waiting(operations.status)
    move_to = _waiting(operations.move_to)
    move_joints = _waiting(operations.move_joints)
    suction = _waiting(operations.suction)
    gripper = _waiting(operations.gripper)
    speed = _waiting(operations.speed)
    mouse = _waiting(operations.mouse)
    say = _waiting(operations.say)
    hand = _waiting(operations.hand)
    vector = _waiting(operations.vector)
    set_jog = _waiting(operations.set_jog)
    set_moves = _waiting(operations.set_moves)
    set_writing = _waiting(operations.set_writing)
    set_angles = _waiting(operations.set_angles)
    set_tool = _waiting(operations.set_tool)
    arm_laser = _waiting(operations.arm_laser)
    disarm_laser = _waiting(operations.disarm_laser)
    laser = _waiting(operations.laser)
    draw = _waiting(operations.draw)
    run = _waiting(operations.run)
    check = _waiting(operations.check)
    resume = _waiting(operations.resume)
    cancel = _waiting(operations.cancel)
    world = _waiting(operations.world)
    set_faults = _waiting(operations.set_faults)
    wait = _waiting(operations.wait)
    stop = _waiting(operations.stop)
    reset_stop = _waiting(operations.reset_stop)
    confirm_pose = _waiting(operations.confirm_pose)

    @property
    def pose(self) -> Status:
        """The pose of the tool, in millimetres and degrees: ``x_mm``, ``y_mm``, ``z_mm``, ``rotation_deg``."""
        return self.status()

    @property
    def ink(self) -> list[Stroke]:
        """The lines of ink under a virtual arm of this process: x and y in the base frame, in mm."""
        return self.world().ink

    @property
    def objects(self) -> dict[str, Object]:
        """The objects around a virtual arm of this process, by name."""
        return self.world().objects

    @property
    def joints(self) -> Status:
        """The joint angles, in degrees: ``base_deg``, ``rear_deg``, ``fore_deg``, ``servo_deg``."""
        return self.status()

    def jog(self, button: Button, speed: float = 50.0, *, at_most: float = 10.0) -> Jog:
        """Holds a button while a ``with`` block runs, at ``speed`` percent.

        The button is released at the end of the block, when the program ends or hangs, and after ``at_most``
        seconds (0.02 to 60), which raises :class:`Failed` at the end of the block. ``arm.wait(...)`` and
        ``arm.statuses()`` can be used in the block.
        """
        return Jog(self, button, speed, at_most)

    def statuses(self) -> Iterator[Status]:
        """Yields all statuses from now on, also while another thread moves the arm."""
        statuses = self._core.statuses()
        while True:
            yield Status(**statuses.next())

    def close(self) -> None:
        """Disconnects from the arm; also called at the end of ``with``."""
        self._core.close()


def _connecting(begin: Callable[P, Core]) -> Callable[P, Arm]:
    """The same, and waits until it is connected."""

    @wraps(begin)
    def connect(*args: P.args, **options: P.kwargs) -> Arm:
        core = begin(*args, **options)
        core.connected().wait(None)
        return Arm(core)

    return connect


connect = _connecting(place.connect)


class Jog:
    """A jog button that is held while a ``with`` block runs."""

    def __init__(self, arm: Arm, button: Button, speed: float, at_most: float) -> None:
        self._arm = arm
        self._press = (button, speed, at_most)

    def __enter__(self) -> None:
        try:
            self._arm._core.press(*self._press).wait(None)
        except KeyboardInterrupt:
            self._let_go_quietly()
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
            self._let_go_quietly()

    def _let_go_quietly(self) -> None:
        """What went wrong before is what counts."""
        try:
            self._arm._core.release().wait(None)
        except Error:
            pass
