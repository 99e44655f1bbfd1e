"""The operations of an arm, defined once for blocking calls and for coroutines."""

from __future__ import annotations

import warnings
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Generic, Literal, TypeVar

from ._core import Core, Pending, joints_warning, point_warning
from .drawing import Plan, Progress, bar
from .programs import Ask, Program, ProgramProgress, ProgramReport, Question, program_bar
from .status import Status
from .world import World

if TYPE_CHECKING:
    from ._core import StatusFields

T = TypeVar("T")

Path = Literal["jump", "movl", "movj"]
"""The path: lift, across and down; a straight line; all joints together."""

Button = Literal[
    "x+", "x-", "y+", "y-", "z+", "z-", "base+", "base-", "rear+", "rear-", "fore+", "fore-",
    "servo+", "servo-", "gripper+", "gripper-",
]
"""A jog button: a direction of the tool, a joint, the servo or the gripper."""


Tool = Literal["suction-cup", "gripper", "pen", "laser"]
"""A tool at the end of the arm."""


class Connection:
    """The common base of the blocking and the asynchronous arm."""

    def __init__(self, core: Core) -> None:
        self._core = core


@dataclass(frozen=True)
class Operation(Generic[T]):
    """An operation in progress, and the conversion of its result."""

    pending: Pending
    read: Callable[[Any], T]
    progress: Callable[..., object] | None = None


def _nothing(result: object) -> None:
    pass


def _status(fields: StatusFields) -> Status:
    return Status(**fields)


def _warn(text: str | None) -> None:
    """Warns the caller of an operation."""
    if text is not None:
        warnings.warn(text, stacklevel=4)


def status(arm: Connection) -> Operation[Status]:
    """Returns the next status. Waits for an arm that has just been switched on."""
    return Operation(arm._core.status(), _status)


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
) -> Operation[Status]:
    """Moves to a point (mm) and waits until the arm has arrived.

    ``r`` is the tool's rotation in the base frame and ``gripper`` the gripper's angle (degrees); ``suction``
    switches the pump after the move; ``pause`` is the time to wait there (seconds). Omitted values do not
    change. Raises :class:`Refused` if the rules do not allow the move, :class:`Stopped` if the arm is stopped
    through this object. Ctrl-C stops the arm. Warns if the point looks like metres.
    """
    point = (x, y, z)
    _warn(point_warning(point))
    return Operation(arm._core.move_to(point, r, (path, suction, gripper, pause)), _status)


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
) -> Operation[Status]:
    """Moves to joint angles (degrees) and waits until the arm has arrived; otherwise like ``move_to``.

    Warns if the angles look like radians.
    """
    joints = (base, rear, fore)
    _warn(joints_warning(joints))
    return Operation(
        arm._core.move_joints(joints, servo, (path, suction, gripper, pause)), _status
    )


def suction(arm: Connection, on: bool) -> Operation[None]:
    """Switches the pump at the current position."""
    return Operation(arm._core.suction(on), _nothing)


def gripper(arm: Connection, angle: float) -> Operation[None]:
    """Turns the gripper at the current position: -90 to 90 degrees."""
    return Operation(arm._core.gripper(angle), _nothing)


def speed(arm: Connection, velocity: float = 50.0, acceleration: float = 50.0) -> Operation[None]:
    """Sets the speed and the acceleration of moves, in percent (state 10)."""
    return Operation(arm._core.speed(velocity, acceleration), _nothing)


def mouse(
    arm: Connection,
    x: float,
    y: float,
    z: float,
    *,
    rotation: float | None = None,
    suction: bool | None = None,
) -> Operation[Status]:
    """Moves by a small distance, as with a mouse (state 1), and waits until the arm is at rest.

    With the dialect ``specification`` the distance is in mm along x, y and z, and ``rotation`` the tool's
    rotation in the base frame. With ``firmware-1.1`` one unit of ``x`` changes the reach by 0.4 mm, one of
    ``y`` turns the base by -0.225 degrees, one of ``z`` lifts by 0.4 mm, and ``rotation`` is the servo's angle;
    such an arm then loses the joint speeds of :meth:`set_moves`. Omitted values do not change.
    """
    return Operation(arm._core.mouse((x, y, z), rotation, suction), _status)


def say(arm: Connection, text: str) -> Operation[Status]:
    """Sends a voice command as text (state 5), and waits until it is carried out.

    It has one order: ahead, back, left, right, up or down with a number of mm in English words
    (``"left ten"``), or catch, or release. Raises :class:`ValueError` for other texts.
    """
    return Operation(arm._core.say(text), _status)


def hand(
    arm: Connection, x: float, y: float, z: float, *, grab: bool | None = None
) -> Operation[Status]:
    """Moves to the position of a hand, as with a hand tracker (state 8), and waits until the arm is at rest.

    With the dialect ``specification`` the position is a point in mm. With ``firmware-1.1`` it is in units of the
    hand tracker, one call moves the arm only part of the way, and the joint speeds of :meth:`set_moves` are
    lost, as ``dobot hand --help`` explains. ``grab`` is a closed hand: the pump runs. Omitted, it does not
    change.
    """
    return Operation(arm._core.hand((x, y, z), grab), _status)


def vector(
    arm: Connection,
    x: float,
    y: float,
    z: float,
    *,
    speed: float = 20.0,
    start_speed: float = 0.0,
    end_speed: float = 0.0,
    burn: bool = False,
) -> Operation[Status]:
    """Draws one straight line (state 4): a distance in mm, from the current position.

    Speeds are in mm/s; ``speed`` is the maximum. Use an end speed only if another vector follows immediately.
    ``burn=True`` burns the line with the laser, which must be armed (:meth:`arm_laser`).
    """
    return Operation(arm._core.vector((x, y, z), (speed, start_speed, end_speed), burn), _status)


def set_jog(
    arm: Connection,
    *,
    joint_speed: float = 15.0,
    joint_acceleration: float = 50.0,
    servo_speed: float = 30.0,
    servo_acceleration: float = 50.0,
    linear_speed: float = 60.0,
    linear_acceleration: float = 60.0,
) -> Operation[None]:
    """Sets the speeds of jogs at 100 % (state 9, mode 0), in degrees/s, mm/s, and the same per second.

    The arm receives all values together: omitted ones are set to these defaults. It forgets them when it is
    switched off; so it does with all settings.
    """
    speeds = (
        joint_speed, joint_acceleration, servo_speed, servo_acceleration, linear_speed, linear_acceleration,
    )
    return Operation(arm._core.set_jog(speeds), _nothing)


def set_moves(
    arm: Connection,
    *,
    joint_speed: float = 200.0,
    joint_acceleration: float = 200.0,
    servo_speed: float = 200.0,
    servo_acceleration: float = 200.0,
    linear_speed: float = 100.0,
    linear_acceleration: float = 200.0,
    pause: float = 0.0,
    jump_height: float = 20.0,
) -> Operation[None]:
    """Sets the speeds of moves at 100 %, their default pause (seconds; ignored by arms as sold) and the height of
    a JUMP (mm; state 9, mode 1); otherwise like ``set_jog``. :meth:`speed` sets the percentages.
    """
    speeds = (
        joint_speed, joint_acceleration, servo_speed, servo_acceleration, linear_speed, linear_acceleration,
    )
    return Operation(arm._core.set_moves(speeds, pause, jump_height), _nothing)


def set_writing(arm: Connection, *, acceleration: float = 100.0) -> Operation[None]:
    """Sets the acceleration of vectors, in mm/s2 (state 9, mode 2)."""
    return Operation(arm._core.set_writing(acceleration), _nothing)


def set_angles(arm: Connection, rear: float, fore: float) -> Operation[None]:
    """Sets the current angles of the rear arm (degrees from the vertical) and the forearm (degrees below the
    horizontal); the base becomes 0 (state 9, mode 3).
    """
    return Operation(arm._core.set_angles(rear, fore), _nothing)


def set_tool(arm: Connection, tool: Tool) -> Operation[None]:
    """Sets the mounted tool (state 9, mode 4)."""
    return Operation(arm._core.set_tool(tool), _nothing)


def arm_laser(arm: Connection, seconds: float) -> Operation[None]:
    """Arms the laser for this many seconds, as far as the policy allows it. Everyone present must wear goggles."""
    return Operation(arm._core.arm_laser(seconds), _nothing)


def disarm_laser(arm: Connection) -> Operation[None]:
    """Switches the laser off and keeps it off."""
    return Operation(arm._core.disarm_laser(), _nothing)


def laser(arm: Connection, on: bool) -> Operation[None]:
    """Switches the laser at the current position. It must be armed, and the policy may forbid a laser that is
    on while the arm stands.
    """
    return Operation(arm._core.laser(on), _nothing)


def draw(arm: Connection, plan: Plan, *, progress: Progress | None = bar) -> Operation[None]:
    """Draws a plan as a job and waits until it is done.

    The paper is at the height of the plan (``pen_down``, ``paper``), else at that of a station's calibration,
    else at the current height of the pen. ``progress`` is called with the number of completed commands and the
    number of commands; an exception in it stops the arm. Raises :class:`Paused` if the job waits for another
    pen or somebody pauses it, :class:`Failed` if it is cancelled or fails.
    """
    return Operation(arm._core.draw(plan._drawing), _nothing, progress)


def run(
    arm: Connection,
    program: Program,
    *,
    times: int | Literal["forever"] | None = None,
    from_step: int = 1,
    progress: ProgramProgress | None = program_bar,
    ask: Ask | None = None,
) -> Operation[None]:
    """Runs a program as a job, and waits until it is done.

    ``times`` is the number of repetitions (default: that of the program); ``"forever"`` ends with Ctrl-C,
    ``arm.stop()``, or when somebody ends the job. ``from_step`` is the first step to execute, counted from 1 as
    in :attr:`ProgramReport.steps`. ``progress`` is called with the step, the number of steps, the cycle, and
    the number of cycles (None for endless programs), counted from 1; an exception in it stops the arm.
    ``ask`` answers the questions of the program: it is called with a :class:`Question`, and returns one of its
    answers, or the position that it asks for: x, y, z (mm) and optionally the rotation (degrees). Without it,
    the questions are answered elsewhere, for example on the station's page.

    Raises :class:`Refused` (kind ``bad-program``) with all problems before anything moves, :class:`Paused` if a
    step waits for a person, :class:`Failed` if the job is cancelled or fails.
    """
    if times == "forever":
        count: int | None = 0
    elif times is None or (isinstance(times, int) and times >= 1):
        count = times
    else:
        raise ValueError(f'times is {times!r}; allowed are 1 or more, and "forever"')
    pending = arm._core.run(program._taught, count, from_step, ask is not None)

    def report(*part: Any) -> None:
        if len(part) == 1:
            if ask is not None:
                pending.answer(*_answer(ask(Question._of(part[0]))))
        elif progress is not None:
            progress(*part)

    return Operation(pending, _nothing, report)


def _answer(given: str | Sequence[float]) -> tuple[str | None, tuple[float, float, float, float] | None]:
    if isinstance(given, str):
        return given, None
    x, y, z, *rest = given
    return None, (x, y, z, rest[0] if rest else 0.0)


def check(arm: Connection, program: Program) -> Operation[ProgramReport]:
    """Checks a program for this arm and its current position; nothing moves."""
    return Operation(arm._core.check(program._taught), ProgramReport._of)


def resume(
    arm: Connection,
    *,
    as_person: bool = False,
    progress: Callable[..., object] | None = None,
) -> Operation[None]:
    """Resumes the job that raised :class:`Paused`, and waits until it is done.

    A job that waits for a person, for example to change the pen, is only resumed with ``as_person=True``: a
    person at the arm has done what it waits for.
    """
    return Operation(arm._core.resume(as_person), _nothing, progress)


def cancel(arm: Connection) -> Operation[None]:
    """Cancels the job that raised :class:`Paused`."""
    return Operation(arm._core.cancel(), _nothing)


def world(arm: Connection) -> Operation[World]:
    """Returns the world of a virtual arm of this process: ink, objects and events. Raises :class:`Failed` for
    other arms, and for a virtual arm without a world.
    """
    return Operation(arm._core.world(), World._of)


def set_faults(arm: Connection, *faults: str, seed: int = 0) -> Operation[None]:
    """Replaces the faults of a virtual arm of this process.

    Faults are ``"drop=1%"``, ``"delay=50ms"``, ``"withhold@1s..3s"``, ``"reset@12s"``, ``"lose=rear:30"``,
    ``"backlash=base:0.3"`` and others, as listed by ``dobot arm --help``; times count from now. Raises
    :class:`ValueError` for an invalid fault.
    """
    return Operation(arm._core.set_faults(list(faults), seed), _nothing)


def wait(arm: Connection, seconds: float) -> Operation[None]:
    """Waits, by the arm's clock."""
    return Operation(arm._core.wait(seconds), _nothing)


def stop(arm: Connection, reason: str | None = None) -> Operation[None]:
    """Stops the arm immediately, whatever another thread or task is doing with it."""
    return Operation(arm._core.stop(reason), _nothing)


def reset_stop(arm: Connection) -> Operation[None]:
    """Resets a stop, after a person has checked the arm."""
    return Operation(arm._core.reset_stop(), _nothing)


def confirm_pose(arm: Connection) -> Operation[None]:
    """Confirms that the arm is where its statuses report, after a person has checked."""
    return Operation(arm._core.confirm_pose(), _nothing)
