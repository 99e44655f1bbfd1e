"""Drawings, planned before any arm moves."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable

from ._core import Drawing

Progress = Callable[[int, int], object]
"""Called with how many commands of how many are over."""


class Plan:
    """A drawing as it will be. It is planned anew for the arm that draws it, where that arm stands."""

    def __init__(self, drawing: Drawing) -> None:
        self._drawing = drawing

    @property
    def title(self) -> str:
        """The name of the file, or the first line of the text."""
        return self._drawing.title

    @property
    def duration_s(self) -> float:
        """How long it takes, in seconds, from its start."""
        return self._drawing.duration_s

    @property
    def vectors(self) -> int:
        """How many vectors it has, and so packets."""
        return self._drawing.vectors

    @property
    def drawn_mm(self) -> float:
        """How far the pen goes down on the paper, in millimetres."""
        return self._drawing.drawn_mm

    @property
    def warnings(self) -> list[str]:
        """What the pen does not show, each a sentence."""
        return self._drawing.warnings

    def svg(self) -> str:
        """A picture of it, as SVG."""
        return self._drawing.svg()

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<Plan {self.title!r}: {self.vectors} vectors, {self.duration_s:.0f} s>"


def plan(file: str | os.PathLike[str] | None = None, **options: object) -> Plan:
    """Plans a drawing: a file (SVG, DXF, HP-GL, G-code, a picture, points), ``text="..."``, or both, the text below.

    The options are those of ``dobot draw`` with ``_`` for ``-``, lengths in millimetres, angles in degrees:
    ``paper_size="a5"``, ``landscape=True``, ``at=[210, 20]``, ``pen_down=-40``. ``paper="a5"`` is short for
    ``paper_size="a5", fit=True``: as large as the sheet allows. Raises :class:`TypeError` for an option that there is not, :class:`ValueError` for a
    value that is not allowed or a drawing that cannot be made so, :class:`OSError` for a file that
    cannot be read.
    """
    if isinstance(options.get("paper"), str):
        if "paper_size" in options:
            raise TypeError("paper and paper_size say the same; give one")
        options["paper_size"] = options.pop("paper")
        if "scale" not in options:
            options.setdefault("fit", True)
    name = None if file is None else os.fspath(file)
    return Plan(Drawing(name, json.dumps(options, allow_nan=False)))


def bar(completed: int, commands: int) -> None:
    """Shows progress on the terminal, if standard error is one."""
    if sys.stderr.isatty():
        end = "\n" if completed == commands else ""
        print(f"\r{completed} of {commands} commands", end=end, file=sys.stderr, flush=True)
