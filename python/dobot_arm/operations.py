"""The operations of an arm, defined once for blocking calls and for coroutines."""

from __future__ import annotations

import json
import warnings
from collections.abc import Callable, Coroutine, Iterable, Sequence
from dataclasses import dataclass
from functools import update_wrapper
from inspect import signature
from typing import TYPE_CHECKING, Any, Concatenate, Generic, Literal, NoReturn, ParamSpec, TypeVar, overload

from ._core import Core, Pending, joints_warning, point_warning
from .drawing import Plan, Progress, bar
from .errors import Failed
from .programs import Ask, Program, ProgramProgress, ProgramReport, Question, SeenPosition, program_bar
from .state import State
from .status import Joints, Pose, Status
from .take import Take
from .world import World

if TYPE_CHECKING:
    from ._core import StatusFields, Taught
    from .aio import AsyncArm
    from .arm import Arm

P = ParamSpec("P")
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


def _points(points: Iterable[Sequence[float]]) -> list[tuple[float, float, float]]:
    found = []
    for at, point in enumerate(points):
        try:
            x, y, z = point
        except (TypeError, ValueError):
            raise ValueError(f"points[{at}] is {point!r}; allowed are three numbers: x, y and z in mm") from None
        found.append((float(x), float(y), float(z)))
    return found


def _taught(program: Program) -> Taught:
    if not isinstance(program, Program):
        raise TypeError(f"program is {program!r}; allowed is a program: `dobot_arm.program({program!r})`")
    return program._taught


def _answer(given: str | Sequence[float]) -> tuple[str | None, tuple[float, float, float, float] | None, bool]:
    if isinstance(given, str):
        return given, None, False
    x, y, z, *rest = given
    return None, (x, y, z, rest[0] if rest else 0.0), isinstance(given, SeenPosition)


class operation(Generic[P, T]):
    """A method of a connection, defined once: :class:`Arm` waits for its end, :class:`AsyncArm` has a coroutine."""

    def __init__(self, begin: Callable[Concatenate[Any, P], Operation[T]]) -> None:
        self.begin = begin

    @overload
    def __get__(self, arm: Arm, owner: type[object] | None = None) -> Callable[P, T]: ...
    @overload
    def __get__(self, arm: AsyncArm, owner: type[object] | None = None) -> Callable[P, Coroutine[Any, Any, T]]: ...
    @overload
    def __get__(self, arm: None, owner: type[object] | None = None) -> Callable[..., Any]: ...
    def __get__(self, arm: object, owner: type[object] | None = None) -> Any:
        raise TypeError("operations belong to Arm and AsyncArm")


def like(begin: Callable[..., object], call: Callable[..., Any], owner: str, returns: str) -> Callable[..., Any]:
    """Gives a call the name, documentation and signature of what begins it, with its own result."""
    update_wrapper(call, begin)
    call.__annotations__ = {**begin.__annotations__, "return": returns}
    call.__signature__ = signature(begin).replace(return_annotation=returns)  # type: ignore[attr-defined]
    call.__qualname__ = f"{owner}.{begin.__name__}" if owner else begin.__name__
    return call


class Connection:
    """The common base of the blocking and the asynchronous arm."""

    def __init__(self, core: Core, where: str) -> None:
        self._core = core
        self._where = where

    def __init_subclass__(cls) -> None:
        for name, method in vars(Connection).items():
            if isinstance(method, operation):
                result = method.begin.__annotations__["return"].removeprefix("Operation[").removesuffix("]")
                call = like(method.begin, cls._calling(method.begin), cls.__name__, result)
                call.__module__ = cls.__module__
                setattr(cls, name, call)

    @staticmethod
    def _calling(begin: Callable[..., Operation[Any]]) -> Callable[..., Any]:
        """Returns the method for an operation."""
        raise NotImplementedError

    def __repr__(self) -> str:
        return f"<{type(self).__name__} {self._where}>"

    def __reduce__(self) -> NoReturn:
        raise TypeError("an arm belongs to the process that connected to it; connect again in the other process")

    def _last(self) -> Status:
        """Returns the last known status."""
        fields = self._core.last_status()
        if fields is None:
            raise Failed("no status has arrived yet", hint="wait for one with `next_status()`")
        return _status(fields)

    @property
    def pose(self) -> Pose:
        """The last known position of the tool: ``x_mm``, ``y_mm``, ``z_mm`` and ``rotation_deg``, in this order.

        It is returned immediately; :meth:`next_status` waits for the next one.
        """
        last = self._last()
        return Pose(last.x_mm, last.y_mm, last.z_mm, last.rotation_deg)

    @property
    def joints(self) -> Joints:
        """The last known joint angles: ``base_deg``, ``rear_deg``, ``fore_deg`` and ``servo_deg``, in this order."""
        last = self._last()
        return Joints(last.base_deg, last.rear_deg, last.fore_deg, last.servo_deg)

    def record(self) -> Take:
        """Records the path of the arm during a ``with`` block, however it is moved, for a program."""
        return Take(self._core)

    @operation
    def next_status(self) -> Operation[Status]:
        """Waits for the next status, and for an arm that has just been switched on, and returns it."""
        return Operation(self._core.next_status(), _status)

    @operation
    def state(self) -> Operation[State]:
        """Returns what the station knows: the arm, its link and dialect, the jobs, a stop, who has control, the laser
        and the policy.
        """
        return Operation(self._core.state(), State._of)

    @operation
    def move_to(
        self,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
        r: float | None = None,
        *,
        path: Path = "movl",
        suction: bool | None = None,
        gripper: float | None = None,
        pause: float = 0.0,
    ) -> Operation[Status]:
        """Moves to a point (mm), straight unless ``path`` says otherwise, and waits until the arm has arrived.

        ``r`` is the tool's rotation in the base frame and ``gripper`` the gripper's angle (degrees); ``suction``
        switches the pump after the move; ``pause`` is the time to wait there (seconds). Omitted values do not
        change; without ``r`` the servo keeps its angle. Raises :class:`Refused` if the rules do not allow the
        move, :class:`Stopped` if the arm is stopped through this object. Ctrl-C stops the arm. Warns if the point
        looks like metres.
        """
        if x is not None and y is not None and z is not None:
            _warn(point_warning((x, y, z)))
        return Operation(self._core.move_to("base", (x, y, z, r), (path, suction, gripper, pause)), _status)

    @operation
    def jump(
        self,
        x: float | None = None,
        y: float | None = None,
        z: float | None = None,
        r: float | None = None,
        *,
        suction: bool | None = None,
        gripper: float | None = None,
        pause: float = 0.0,
    ) -> Operation[Status]:
        """Lifts the tool, moves across and down to a point (mm); otherwise like ``move_to``. :meth:`set_moves` sets
        the height.
        """
        if x is not None and y is not None and z is not None:
            _warn(point_warning((x, y, z)))
        return Operation(self._core.move_to("base", (x, y, z, r), ("jump", suction, gripper, pause)), _status)

    @operation
    def move_by(
        self,
        x: float = 0.0,
        y: float = 0.0,
        z: float = 0.0,
        r: float | None = None,
        *,
        path: Path = "movl",
        suction: bool | None = None,
        gripper: float | None = None,
        pause: float = 0.0,
    ) -> Operation[Status]:
        """Moves by a distance (mm) from the current position, and turns the tool by ``r`` (degrees); otherwise like
        ``move_to``.
        """
        return Operation(self._core.move_to("current", (x, y, z, r), (path, suction, gripper, pause)), _status)

    @operation
    def move_polar(
        self,
        reach: float | None = None,
        angle: float | None = None,
        z: float | None = None,
        r: float | None = None,
        *,
        path: Path = "movj",
        suction: bool | None = None,
        gripper: float | None = None,
        pause: float = 0.0,
    ) -> Operation[Status]:
        """Moves to a distance from the base axis (mm), an angle about it (degrees, 0 forward, positive to the left)
        and a height (mm); otherwise like ``move_to``, but turning all joints together.
        """
        return Operation(self._core.move_to("polar", (reach, angle, z, r), (path, suction, gripper, pause)), _status)

    @operation
    def move_joints(
        self,
        base: float | None = None,
        rear: float | None = None,
        fore: float | None = None,
        servo: float | None = None,
        *,
        path: Path = "movj",
        suction: bool | None = None,
        gripper: float | None = None,
        pause: float = 0.0,
    ) -> Operation[Status]:
        """Moves to joint angles (degrees), turning all joints together; otherwise like ``move_to``.

        Warns if the angles look like radians.
        """
        joints = (base, rear, fore, servo)
        if base is not None and rear is not None and fore is not None:
            _warn(joints_warning((base, rear, fore)))
        return Operation(self._core.move_joints(joints, (path, suction, gripper, pause)), _status)

    @operation
    def follow(
        self,
        points: Iterable[Sequence[float]],
        *,
        speed: float = 40.0,
        title: str = "path",
        progress: Progress | None = None,
    ) -> Operation[None]:
        """Moves straight to the first of these points (x, y, z in mm), then through the others without a stop in
        between, as a job, and waits until it is done.

        ``speed`` is the maximum (mm/s); the arm is slower at corners. Pump, gripper and servo keep their state.
        Otherwise like :meth:`draw`.
        """
        return Operation(self._core.follow(_points(points), speed, title), _nothing, progress)

    @operation
    def mark_episode(
        self, mark: Literal["begin", "end", "discard"], task: str | None = None
    ) -> Operation[None]:
        """Marks the station's recording: an episode of a dataset begins here, as ``task`` describes it, ends here, or
        is discarded. Raises :class:`Refused` if nothing is recorded, as with an arm without a station.
        """
        return Operation(self._core.mark_episode(mark, task), _nothing)

    @operation
    def request_control(self, wait: float = 10.0) -> Operation[None]:
        """Takes control of the arm; every motion does so by itself. If another client has it, asks that client and
        waits for at most ``wait`` seconds. Raises :class:`Refused` if it keeps control.
        """
        return Operation(self._core.request_control(wait), _nothing)

    @operation
    def release_control(self) -> Operation[None]:
        """Releases control, so that others can move the arm."""
        return Operation(self._core.release_control(), _nothing)

    @operation
    def grant_control(self, client: int) -> Operation[None]:
        """Gives control to a client that requests it: one of ``state().control.requests``."""
        return Operation(self._core.grant_control(client), _nothing)

    @operation
    def suction(self, on: bool) -> Operation[None]:
        """Switches the pump at the current position."""
        return Operation(self._core.suction(on), _nothing)

    @operation
    def gripper(self, angle: float) -> Operation[None]:
        """Turns the gripper at the current position: -90 to 90 degrees."""
        return Operation(self._core.gripper(angle), _nothing)

    @operation
    def speed(self, velocity: float = 50.0, acceleration: float = 50.0) -> Operation[None]:
        """Sets the speed and the acceleration of moves, in percent (state 10)."""
        return Operation(self._core.speed(velocity, acceleration), _nothing)

    @operation
    def mouse(
        self,
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
        return Operation(self._core.mouse((x, y, z), rotation, suction), _status)

    @operation
    def say(self, text: str, *, spoken: bool = False) -> Operation[Status]:
        """Sends a voice command as text (state 5), and waits until it is carried out.

        It has one order: ahead, back, left, right, up or down with a number of mm in English words
        (``"left ten"``), or catch, or release. ``spoken`` marks it as heard by a microphone: it then moves at most
        ``voice.largest_mm`` of the policy. Raises :class:`ValueError` for other texts.
        """
        return Operation(self._core.say(text, spoken), _status)

    @operation
    def report_heard(
        self, what: Literal["order", "go", "no", "stop", "nothing"], words: str = "", *, client: int | None = None
    ) -> Operation[None]:
        """Shows on all pages what a microphone heard; nothing moves.

        ``words`` are those of an order. ``client`` is the page whose audio it was, if it was not this program's own.
        """
        heard = {"what": what, **({"words": words} if what == "order" else {})}
        return Operation(self._core.report_heard(json.dumps(heard), client), _nothing)

    @operation
    def hand(
        self, x: float, y: float, z: float, *, grab: bool | None = None, seen: bool = False
    ) -> Operation[Status]:
        """Moves to the position of a hand, as with a hand tracker (state 8), and waits until the arm is at rest.

        With the dialect ``specification`` the position is a point in mm. With ``firmware-1.1`` it is in units of the
        hand tracker, one call moves the arm only part of the way, and the joint speeds of :meth:`set_moves` are
        lost, as ``dobot hand --help`` explains. ``grab`` is a closed hand: the pump runs. Omitted, it does not
        change. ``seen`` marks the hand as seen by a camera; its position is then in mm with every dialect.
        """
        return Operation(self._core.hand((x, y, z), grab, seen), _status)

    @operation
    def vector(
        self,
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
        return Operation(self._core.vector((x, y, z), (speed, start_speed, end_speed), burn), _status)

    @operation
    def set_jog(
        self,
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
        return Operation(self._core.set_jog(speeds), _nothing)

    @operation
    def set_moves(
        self,
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
        return Operation(self._core.set_moves(speeds, pause, jump_height), _nothing)

    @operation
    def set_writing(self, *, acceleration: float = 100.0) -> Operation[None]:
        """Sets the acceleration of vectors, in mm/s2 (state 9, mode 2)."""
        return Operation(self._core.set_writing(acceleration), _nothing)

    @operation
    def set_angles(self, rear: float, fore: float) -> Operation[None]:
        """Sets the current angles of the rear arm (degrees from the vertical) and the forearm (degrees below the
        horizontal); the base becomes 0 (state 9, mode 3).
        """
        return Operation(self._core.set_angles(rear, fore), _nothing)

    @operation
    def set_tool(self, tool: Tool) -> Operation[None]:
        """Sets the mounted tool (state 9, mode 4)."""
        return Operation(self._core.set_tool(tool), _nothing)

    @operation
    def arm_laser(self, seconds: float) -> Operation[None]:
        """Arms the laser for this many seconds, as far as the policy allows it. Everyone present must wear goggles."""
        return Operation(self._core.arm_laser(seconds), _nothing)

    @operation
    def disarm_laser(self) -> Operation[None]:
        """Switches the laser off and keeps it off."""
        return Operation(self._core.disarm_laser(), _nothing)

    @operation
    def laser(self, on: bool) -> Operation[None]:
        """Switches the laser at the current position. It must be armed, and the policy may forbid a laser that is
        on while the arm stands.
        """
        return Operation(self._core.laser(on), _nothing)

    @operation
    def draw(self, plan: Plan, *, progress: Progress | None = bar) -> Operation[None]:
        """Draws a plan as a job and waits until it is done.

        The paper is at the height of the plan (``pen_down``, ``paper``), else at that of a station's calibration,
        else at the current height of the pen. ``progress`` is called with the number of completed commands and the
        number of commands; an exception in it stops the arm. Raises :class:`Paused` if the job waits for another
        pen or somebody pauses it, :class:`Failed` if it is cancelled or fails.
        """
        if not isinstance(plan, Plan):
            raise TypeError(f"plan is {plan!r}; allowed is a plan: `dobot_arm.plan({plan!r})`")
        return Operation(self._core.draw(plan._drawing), _nothing, progress)

    @operation
    def run(
        self,
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
        pending = self._core.run(_taught(program), count, from_step, ask is not None)

        def report(*part: Any) -> None:
            if len(part) == 1:
                if ask is not None:
                    pending.answer(*_answer(ask(Question._of(part[0]))))
            elif progress is not None:
                progress(*part)

        return Operation(pending, _nothing, report)

    @operation
    def check(self, program: Program) -> Operation[ProgramReport]:
        """Checks a program for this arm and its current position; nothing moves."""
        return Operation(self._core.check(_taught(program)), ProgramReport._of)

    @operation
    def resume(
        self,
        *,
        as_person: bool = False,
        progress: Callable[..., object] | None = None,
    ) -> Operation[None]:
        """Resumes the job that raised :class:`Paused`, and waits until it is done.

        A job that waits for a person, for example to change the pen, is only resumed with ``as_person=True``: a
        person at the arm has done what it waits for.
        """
        return Operation(self._core.resume(as_person), _nothing, progress)

    @operation
    def cancel(self) -> Operation[None]:
        """Cancels the job that raised :class:`Paused`."""
        return Operation(self._core.cancel(), _nothing)

    @operation
    def world(self) -> Operation[World]:
        """Returns the world of a virtual arm of this process: ink, objects and events. Raises :class:`Failed` for
        other arms, and for a virtual arm without a world.
        """
        return Operation(self._core.world(), World._of)

    @operation
    def set_faults(self, *faults: str, seed: int = 0) -> Operation[None]:
        """Replaces the faults of a virtual arm of this process.

        Faults are ``"drop=1%"``, ``"delay=50ms"``, ``"withhold@1s..3s"``, ``"reset@12s"``, ``"lose=rear:30"``,
        ``"backlash=base:0.3"`` and others, as listed by ``dobot arm --help``; times count from now. Raises
        :class:`ValueError` for an invalid fault.
        """
        return Operation(self._core.set_faults(list(faults), seed), _nothing)

    @operation
    def wait(self, seconds: float) -> Operation[None]:
        """Waits, by the arm's clock."""
        return Operation(self._core.wait(seconds), _nothing)

    @operation
    def stop(self, reason: str | None = None) -> Operation[None]:
        """Stops the arm immediately, whatever another thread or task is doing with it."""
        return Operation(self._core.stop(reason), _nothing)

    @operation
    def reset_stop(self) -> Operation[None]:
        """Resets a stop, after a person has checked the arm."""
        return Operation(self._core.reset_stop(), _nothing)

    @operation
    def confirm_pose(self) -> Operation[None]:
        """Confirms that the arm is where its statuses report, after a person has checked."""
        return Operation(self._core.confirm_pose(), _nothing)
