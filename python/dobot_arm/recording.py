"""Recordings as tables."""

from __future__ import annotations

import math
import os
from collections.abc import Iterable
from functools import cached_property
from typing import TYPE_CHECKING

from ._core import Log, export_lerobot
from .table import Table

if TYPE_CHECKING:
    from ._core import Columns


class Recording:
    """A recording of a station, or a part of it."""

    def __init__(self, log: Log) -> None:
        self._log = log

    @property
    def statuses(self) -> Table:
        """The statuses of the arm: ``time`` (UTC), ``at_s`` since the recorder was started, the position (mm),
        the angles (degrees), suction and gripper.
        """
        return Table(self._read[0])

    @property
    def commands(self) -> Table:
        """The packets to the arm: ``time``, ``at_s``, the command, its fields as JSON, why it is invalid, and
        its ten floats.
        """
        return Table(self._read[1])

    @property
    def damage(self) -> str | None:
        """The damage of the file; the tables contain what could be read."""
        return self._read[2]

    @cached_property
    def _read(self) -> tuple[Columns, Columns, str | None]:
        return self._log.tables()

    def export(
        self, out: str | os.PathLike[str], *, task: str | None = None, overwrite: bool = False
    ) -> list[str]:
        """Writes tables: statuses to a file that ends in ``.csv`` or ``.parquet``, commands to a second file
        next to it.

        With ``task``, a description of what the arm does, ``out`` is the new folder of a dataset for LeRobot, as
        :func:`dataset` makes it.
        Returns the names of the written files. Raises :class:`FileExistsError` for existing files (unless
        ``overwrite`` is true), :class:`ValueError` if there is nothing to export.
        """
        name = os.fspath(out)
        if task is not None:
            if overwrite:
                raise ValueError("overwrite is not allowed for a dataset, which needs a new folder")
            dataset(name, [self], task=task)
            return [name]
        if not name.endswith((".csv", ".parquet")):
            raise ValueError(f"{name} ends in neither .csv nor .parquet; a dataset needs task=")
        return [name, os.fspath(self._log.export_files(name, name.endswith(".parquet"), overwrite))]


def dataset(
    out: str | os.PathLike[str], recordings: Iterable[Recording], *, task: str, trim_idle: bool = False
) -> tuple[int, int]:
    """Makes one dataset for LeRobot of recordings, in the new folder ``out``; returns the numbers of episodes and
    frames.

    Each recording begins a new episode: parts of one, ``log(file, start=3, end=12)``, are marked episodes. ``task``
    describes what the arm does. ``trim_idle`` leaves out the rest before the first motion and after the last one of
    each episode, but for half a second. Raises :class:`FileExistsError` if the folder exists, :class:`ValueError` if
    there is nothing to export.
    """
    logs = [recording._log for recording in recordings]
    return export_lerobot(logs, os.fspath(out), task, trim_idle)


def log(file: str | os.PathLike[str], *, start: float = 0.0, end: float = math.inf) -> Recording:
    """Opens a recording (MCAP), from ``start`` to ``end`` in seconds since the recorder was started.

    Raises :class:`OSError` if it cannot be read, :class:`ValueError` if it is not a recording.
    """
    return Recording(Log(os.fspath(file), start, end))
