"""What an arm can do: each is written once, for calls that wait and for coroutines."""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar

from ._core import Core, Pending
from .drawing import Plan, Progress, bar
from .programs import Program, ProgramProgress, ProgramReport, program_bar
from .status import Status
from .world import World

if TYPE_CHECKING:
    from ._core import Told

T = TypeVar("T")

Path = Literal["jump", "movl", "movj"]
"""The way there: lift, across and down; in a straight line; all joints at once."""

Button = Literal[
    "x+", "x-", "y+", "y-", "z+", "z-", "base+", "base-", "rear+", "rear-", "fore+", "fore-",
    "servo+", "servo-", "gripper+", "gripper-",
]
"""A jog button: a direction of the tool, a joint, the servo or the gripper."""


class Connection:
    """What both faces of an arm have in common."""

    def __init__(self, core: Core) -> None:
        self._core = core


@dataclass(frozen=True)
class Begun(Generic[T]):
    """An operation that goes on, and how to read what comes of it."""

    pending: Pending
    read: Callable[[Any], T]
    progress: Callable[..., object] | None = None


def _nothing(told: object) -> None:
    pass


def _status(told: Told) -> Status:
    return Status(**told)


def status(arm: Connection) -> Begun[Status]:
    """What the arm tells next. An arm that has just been switched on is waited for."""
    return Begun(arm._core.status(), _status)


def move_to(
    arm: Connection,
    x: float,
    y: float,
    z: float,
    r: float | None = None,
    *,
    path: Path = "jump",
    suction: bool | None = None,
    gripper: float | None = None,
    pause: float = 0.0,
) -> Begun[Status]:
    """Goes to a point (mm) and waits until it has arrived.

    ``r`` is the tool's rotation in the base frame and ``gripper`` the gripper's angle (degrees);
    ``suction`` is switched once there; ``pause`` is how long to wait there (seconds). What is left
    out stays as it is. Raises :class:`Refused` where the rules do not allow it, :class:`Stopped`
    where somebody stops the arm through this object. Ctrl-C stops the arm.
    """
    return Begun(arm._core.move_to((x, y, z), r, (path, suction, gripper, pause)), _status)


def move_joints(
    arm: Connection,
    base: float,
    rear: float,
    fore: float,
    servo: float | None = None,
    *,
    path: Path = "jump",
    suction: bool | None = None,
    gripper: float | None = None,
    pause: float = 0.0,
) -> Begun[Status]:
    """Goes to joint angles (degrees) and waits until it has arrived; otherwise as ``move_to``.

    Warns of angles that look like radians.
    """
    joints = (base, rear, fore)
    if all(abs(it) <= math.pi for it in joints) and any(it != int(it) for it in joints):
        warnings.warn(
            f"the joint angles {joints} look like radians; they are degrees", stacklevel=3
        )
    return Begun(
        arm._core.move_joints(joints, servo, (path, suction, gripper, pause)), _status
    )


def suction(arm: Connection, on: bool) -> Begun[None]:
    """Switches the pump where the arm is."""
    return Begun(arm._core.suction(on), _nothing)


def gripper(arm: Connection, angle: float) -> Begun[None]:
    """Turns the gripper where the arm is: -90 to 90 degrees."""
    return Begun(arm._core.gripper(angle), _nothing)


def speed(arm: Connection, velocity: float = 50.0, acceleration: float = 50.0) -> Begun[None]:
    """Shares of the speed and of the acceleration of moves, in percent (state 10)."""
    return Begun(arm._core.speed(velocity, acceleration), _nothing)


def arm_laser(arm: Connection, seconds: float) -> Begun[None]:
    """Lets the laser be switched on for so many seconds, as far as the policy allows it: everybody's
    goggles are on."""
    return Begun(arm._core.arm_laser(seconds), _nothing)


def disarm_laser(arm: Connection) -> Begun[None]:
    """Switches the laser off and keeps it off."""
    return Begun(arm._core.disarm_laser(), _nothing)


def laser(arm: Connection, on: bool) -> Begun[None]:
    """Switches the laser where the arm is. It has to be armed, and the policy may forbid a light
    that stands."""
    return Begun(arm._core.laser(on), _nothing)


def draw(arm: Connection, plan: Plan, *, progress: Progress | None = bar) -> Begun[None]:
    """Draws it as a job and waits until that is over.

    The paper lies where the plan says (``pen_down``, ``paper``), else where a station knows it by
    calibration, else where the pen stands now. ``progress`` is called with how many commands of
    how many are over; what it raises stops the arm. Raises :class:`Paused` where it waits for another
    pen or somebody pauses it, :class:`Failed` where it is cancelled or fails.
    """
    return Begun(arm._core.draw(plan._drawing), _nothing, progress)


def run(
    arm: Connection,
    program: Program,
    *,
    times: int | Literal["forever"] | None = None,
    from_step: int = 1,
    progress: ProgramProgress | None = program_bar,
) -> Begun[None]:
    """Does a program as a job, and waits until that is over.

    ``times`` is how often it is done, where that is not as often as it says itself; ``"forever"`` ends with
    Ctrl-C, ``arm.stop()``, or where somebody ends the job. ``from_step`` is the step with which it begins,
    as :attr:`ProgramReport.steps` counts them from 1. ``progress`` is called with the step, how many there are, the cycle, and how many
    there are (None where it goes on for ever), all counted from 1; what it raises stops the arm.

    Raises :class:`Refused` (kind ``bad-program``) with all that is wrong before anything moves,
    :class:`Paused` where a step waits for a person, :class:`Failed` where it is cancelled or fails.
    """
    if times == "forever":
        count: int | None = 0
    elif times is None or (isinstance(times, int) and times >= 1):
        count = times
    else:
        raise ValueError(f'times is {times!r}; allowed are 1 or more, and "forever"')
    return Begun(arm._core.run(program._taught, count, from_step), _nothing, progress)


def check(arm: Connection, program: Program) -> Begun[ProgramReport]:
    """Looks at a program for this arm, where it stands; nothing moves."""
    return Begun(arm._core.check(program._taught), ProgramReport._of)


def resume(
    arm: Connection,
    *,
    as_person: bool = False,
    progress: Callable[..., object] | None = None,
) -> Begun[None]:
    """Goes on with the job that told it was :class:`Paused`, and waits until that is over.

    A job that waits for a person, to change the pen say, goes on only with ``as_person=True``: somebody at the arm
    has done what it waits for.
    """
    return Begun(arm._core.resume(as_person), _nothing, progress)


def cancel(arm: Connection) -> Begun[None]:
    """Gives up the job that told it was :class:`Paused`."""
    return Begun(arm._core.cancel(), _nothing)


def world(arm: Connection) -> Begun[World]:
    """What is around a virtual arm of this process: ink, objects and what happened. Raises :class:`Failed` for other arms,
    and where nothing is around it."""
    return Begun(arm._core.world(), World._of)


def set_faults(arm: Connection, *faults: str, seed: int = 0) -> Begun[None]:
    """Lets these things go wrong with a virtual arm of this process from now on, and nothing else any more.

    ``"drop=1%"``, ``"delay=50ms"``, ``"withhold@1s..3s"``, ``"reset@12s"``, ``"lose=rear:30"``, ``"backlash=base:0.3"`` and others,
    as `dobot arm --help` lists them; times count from now. Raises :class:`ValueError` for a text that is no fault.
    """
    return Begun(arm._core.set_faults(list(faults), seed), _nothing)


def wait(arm: Connection, seconds: float) -> Begun[None]:
    """Lets time pass by the arm's clock."""
    return Begun(arm._core.wait(seconds), _nothing)


def stop(arm: Connection, reason: str | None = None) -> Begun[None]:
    """Stops the arm at once, whatever another thread or task has it do."""
    return Begun(arm._core.stop(reason), _nothing)


def reset_stop(arm: Connection) -> Begun[None]:
    """Lets the arm move again after a stop: a person has looked at it."""
    return Begun(arm._core.reset_stop(), _nothing)


def confirm_pose(arm: Connection) -> Begun[None]:
    """Says that a person has looked: the arm stands where it says."""
    return Begun(arm._core.confirm_pose(), _nothing)
