"""An arm for asyncio."""

from __future__ import annotations

import asyncio
import os
from collections.abc import AsyncIterator, Callable, Sequence
from types import TracebackType
from typing import Any

from . import place
from ._core import Pending, Statuses
from .errors import Error
from .operations import Operation, Button, Connection
from .status import Status

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


    @staticmethod
    def _calling(begin: Callable[..., Operation[Any]]) -> Callable[..., Any]:
        async def call(self: AsyncArm, *args: Any, **options: Any) -> Any:
            begun = begin(self, *args, **options)
            return begun.read(await _result_or_stopped(self, begun.pending, begun.progress))

        return call

    def jog(self, button: Button, speed: float = 50.0, *, at_most: float = 10.0) -> AsyncJog:
        """Holds a button while an ``async with`` block runs; otherwise like :meth:`Arm.jog`."""
        return AsyncJog(self, button, speed, at_most)

    def statuses(self) -> AsyncIterator[Status]:
        """Returns all statuses from now on, also while another task moves the arm."""
        return _each(self._core.statuses())

    async def close(self) -> None:
        """Disconnects from the arm; also called at the end of ``async with``."""
        await asyncio.to_thread(self._core.close)


async def _each(statuses: Statuses) -> AsyncIterator[Status]:
    while True:
        status = statuses.poll()
        if status is None:
            await _ready(statuses)
        else:
            yield Status(**status)


async def aconnect(
    where: str,
    *,
    name: str | None = None,
    token: str | None = None,
    dialect: str | None = None,
    fingerprint: str | None = None,
    ca: str | os.PathLike[str] | None = None,
    world: str | os.PathLike[str] | None = None,
    faults: Sequence[str] = (),
    seed: int = 0,
) -> AsyncArm:
    """Connects to an arm for coroutines; otherwise like :func:`connect`."""
    core = place.connect(where, name, token, dialect, fingerprint, ca, world, faults, seed)
    await _result(core.connected())
    return AsyncArm(core, where)


class AsyncJog:
    """A jog button that is held while an ``async with`` block runs."""

    def __init__(self, arm: AsyncArm, button: Button, speed: float, at_most: float) -> None:
        self._arm = arm
        self._press = (button, speed, at_most)

    async def __aenter__(self) -> None:
        try:
            await _result_or_stopped(self._arm, self._arm._core.press(*self._press), None)
        except asyncio.CancelledError:
            await self._release_quietly()
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
            await self._release_quietly()

    async def _release_quietly(self) -> None:
        """Releases the button without hiding an earlier error."""
        try:
            await _result(self._arm._core.release())
        except Error:
            pass
