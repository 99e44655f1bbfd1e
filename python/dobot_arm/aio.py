"""An arm for asyncio."""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable, Coroutine
from functools import wraps
from types import TracebackType
from typing import Any, Concatenate, ParamSpec, TypeVar

from . import operations, place
from ._core import Core, Pending, Statuses
from .errors import Error
from .operations import Operation, Button, Connection
from .status import Status

P = ParamSpec("P")
T = TypeVar("T")


async def _ready(source: Pending | Statuses) -> None:
    """Waits until there is something to poll."""
    loop = asyncio.get_running_loop()
    ready = loop.create_future()

    def finish() -> None:
        if not ready.done():
            ready.set_result(None)

    def wake() -> None:
        try:
            loop.call_soon_threadsafe(finish)
        except RuntimeError:
            pass  # The loop is closed: there is no waiter.

    source.when_ready(wake)
    await ready


async def _result(pending: Pending, progress: Callable[..., object] | None = None) -> Any:
    while True:
        await _ready(pending)
        part, result = pending.poll()
        if result is not None:
            return result
        if part is not None and progress is not None:
            progress(*part)


async def _result_or_stopped(
    arm: Connection, pending: Pending, progress: Callable[..., object] | None
) -> Any:
    """Waits for the end; if the task is cancelled or ``progress`` raises, the arm is stopped."""
    try:
        return await _result(pending, progress)
    except Error:
        raise
    except BaseException as error:
        try:
            await _result(arm._core.stop(f"a task was cancelled: {error!r}"))
        except Error:
            pass
        raise


def _awaited(
    begin: Callable[Concatenate[Connection, P], Operation[T]],
) -> Callable[Concatenate[Connection, P], Coroutine[Any, Any, T]]:
    """Returns the operation as a coroutine. If its task is cancelled, the arm is stopped."""

    @wraps(begin)
    async def call(arm: Connection, /, *args: P.args, **options: P.kwargs) -> T:
        begun = begin(arm, *args, **options)
        return begun.read(await _result_or_stopped(arm, begun.pending, begun.progress))

    return call


class AsyncArm(Connection):
    """An arm with awaitable operations. Tasks and event loops may share it."""

    async def __aenter__(self) -> AsyncArm:
        return self

    async def __aexit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        await self.close()

    status = _awaited(operations.status)
    move_to = _awaited(operations.move_to)
    move_joints = _awaited(operations.move_joints)
    suction = _awaited(operations.suction)
    gripper = _awaited(operations.gripper)
    speed = _awaited(operations.speed)
    mouse = _awaited(operations.mouse)
    say = _awaited(operations.say)
    hand = _awaited(operations.hand)
    vector = _awaited(operations.vector)
    set_jog = _awaited(operations.set_jog)
    set_moves = _awaited(operations.set_moves)
    set_writing = _awaited(operations.set_writing)
    set_angles = _awaited(operations.set_angles)
    set_tool = _awaited(operations.set_tool)
    arm_laser = _awaited(operations.arm_laser)
    disarm_laser = _awaited(operations.disarm_laser)
    laser = _awaited(operations.laser)
    draw = _awaited(operations.draw)
    run = _awaited(operations.run)
    check = _awaited(operations.check)
    resume = _awaited(operations.resume)
    cancel = _awaited(operations.cancel)
    world = _awaited(operations.world)
    set_faults = _awaited(operations.set_faults)
    wait = _awaited(operations.wait)
    stop = _awaited(operations.stop)
    reset_stop = _awaited(operations.reset_stop)
    confirm_pose = _awaited(operations.confirm_pose)

    def jog(self, button: Button, speed: float = 50.0, *, at_most: float = 10.0) -> AsyncJog:
        """Holds a button while an ``async with`` block runs; otherwise like :meth:`Arm.jog`."""
        return AsyncJog(self, button, speed, at_most)

    async def statuses(self) -> AsyncIterator[Status]:
        """Yields all statuses from now on, also while another task moves the arm."""
        statuses = self._core.statuses()
        while True:
            status = statuses.poll()
            if status is None:
                await _ready(statuses)
            else:
                yield Status(**status)

    async def close(self) -> None:
        """Disconnects from the arm; also called at the end of ``async with``."""
        await asyncio.to_thread(self._core.close)


def _connecting(begin: Callable[P, Core]) -> Callable[P, Coroutine[Any, Any, AsyncArm]]:
    """Returns the operation as a coroutine."""

    @wraps(begin)
    async def aconnect(*args: P.args, **options: P.kwargs) -> AsyncArm:
        core = begin(*args, **options)
        await _result(core.connected())
        return AsyncArm(core)

    return aconnect


aconnect = _connecting(place.connect)


class AsyncJog:
    """A jog button that is held while an ``async with`` block runs."""

    def __init__(self, arm: AsyncArm, button: Button, speed: float, at_most: float) -> None:
        self._arm = arm
        self._press = (button, speed, at_most)

    async def __aenter__(self) -> None:
        try:
            await _result_or_stopped(self._arm, self._arm._core.press(*self._press), None)
        except asyncio.CancelledError:
            await self._let_go_quietly()
            raise

    async def __aexit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if error is None:
            await _result(self._arm._core.release())
        else:
            await self._let_go_quietly()

    async def _let_go_quietly(self) -> None:
        """Releases the button without hiding an earlier error."""
        try:
            await _result(self._arm._core.release())
        except Error:
            pass
