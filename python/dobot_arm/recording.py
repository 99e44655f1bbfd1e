"""Recordings as tables."""

from __future__ import annotations

import math
import os
from functools import cached_property
from typing import TYPE_CHECKING

from ._core import Log
from .table import Table

if TYPE_CHECKING:
    from ._core import Columns


class Recording:
    """A recording of a station, or a stretch of it."""

    def __init__(self, log: Log) -> None:
        self._log = log

    @property
    def statuses(self) -> Table:
        """What the arm told: ``time`` (UTC), ``at_s`` since the recorder was started, the place (mm), the angles (degrees),
        suction and gripper."""
        return Table(self._read[0])

    @property
    def commands(self) -> Table:
        """What was sent to the arm: ``time``, ``at_s``, what it is, its fields as JSON, why it is none, and its ten floats."""
        return Table(self._read[1])

    @property
    def damage(self) -> str | None:
        """What is wrong with the file; the tables hold what could be read."""
        return self._read[2]

    @cached_property
    def _read(self) -> tuple[Columns, Columns, str | None]:
        return self._log.tables()

    def export(
        self, out: str | os.PathLike[str], *, task: str | None = None, overwrite: bool = False
    ) -> list[str]:
        """Writes it as tables: statuses to a file that ends in ``.csv`` or ``.parquet``, commands to one beside it.

        With ``task``, in words what the arm does, ``out`` is the new folder of a dataset that LeRobot loads. Gives the names
        of what was written. Raises :class:`FileExistsError` for what is there already (``overwrite`` writes over
        files), :class:`ValueError` where there is nothing to export.
        """
        name = os.fspath(out)
        if task is not None:
            if overwrite:
                raise ValueError("overwrite is given, but the folder of a dataset is never written over")
            self._log.export_lerobot(name, task)
            return [name]
        if not name.endswith((".csv", ".parquet")):
            raise ValueError(f"{name} ends in neither .csv nor .parquet; a dataset needs task=")
        return [name, os.fspath(self._log.export_files(name, name.endswith(".parquet"), overwrite))]


def log(file: str | os.PathLike[str], *, start: float = 0.0, end: float = math.inf) -> Recording:
    """Opens a recording (MCAP), from ``start`` to ``end`` in seconds since the recorder was started.

    Raises :class:`OSError` where it cannot be read, :class:`ValueError` where it is none.
    """
    return Recording(Log(os.fspath(file), start, end))
