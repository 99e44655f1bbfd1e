"""Drawings, planned before any arm moves."""

from __future__ import annotations

import os
import reprlib
import sys
from collections.abc import Callable, Iterable
from itertools import islice
from struct import Struct
from struct import error as StructError
from typing import TYPE_CHECKING, Any

from ._core import Drawing, Lines, drawing_formats
from .values import json_object

if TYPE_CHECKING:
    import numpy as np

    Points = np.ndarray[Any, Any] | Iterable[tuple[float, float]]
    """The points of a line: an array of shape (n, 2), or pairs."""

_PAIR = Struct("<2d")
_PIECE = 4096
"""The number of points that are passed together."""

Progress = Callable[[int, int], object]
"""Called with the number of completed commands and the number of commands."""


class Plan:
    """A planned drawing. It is planned again for the arm that draws it, from the position of that arm."""

    def __init__(self, drawing: Drawing) -> None:
        self._drawing = drawing

    @property
    def title(self) -> str:
        """The name of the file, or the first line of the text."""
        return self._drawing.title

    @property
    def duration_s(self) -> float:
        """The duration in seconds, from its start."""
        return self._drawing.duration_s

    @property
    def vectors(self) -> int:
        """The number of vectors, and so of packets."""
        return self._drawing.vectors

    @property
    def drawn_mm(self) -> float:
        """The drawn length, in millimetres."""
        return self._drawing.drawn_mm

    @property
    def warnings(self) -> list[str]:
        """Differences between the result and the file, a sentence each."""
        return self._drawing.warnings

    @property
    def strokes(self) -> list[list[tuple[float, float]]]:
        """The ink, line by line: x and y in the base frame, in millimetres."""
        return self._drawing.strokes()

    def svg(self) -> str:
        """A picture of the drawing, as SVG."""
        return self._drawing.svg()

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<Plan {self.title!r}: {self.vectors} vectors, {self.duration_s:.0f} s>"


def formats() -> dict[str, list[str]]:
    """Returns the supported file formats with their extensions, as in ``{"DXF": ["dxf"], ...}``."""
    return dict(drawing_formats())


def plan(
    file: str | os.PathLike[str] | None = None, *, lines: Iterable[Points] | None = None, **options: object
) -> Plan:
    """Plans a drawing: a file in one of the :func:`formats`, ``lines=[...]``, ``text="..."``, or a file or
    lines with a text below.

    ``lines`` are arrays of shape (n, 2), or sequences of pairs: x to the right and y down, in millimetres, as
    on a page.

    The options are keyword arguments, with lengths in millimetres and angles in degrees: ``paper_size="a5"``,
    ``landscape=True``, ``at=[210, 20]``, ``pen_down=-40``; ``dobot draw --help`` describes all of them (with
    ``-`` for ``_``). ``paper="a5"`` is short for ``paper_size="a5", fit=True``: as large as the sheet allows,
    but a text with a ``height`` keeps it.

    Raises :class:`TypeError` for an unknown option, :class:`ValueError` for an invalid value or a drawing that
    cannot be planned, :class:`OSError` for a file that cannot be read.
    """
    if isinstance(options.get("paper"), str):
        if "paper_size" in options:
            raise TypeError("paper and paper_size have the same meaning; give one of them")
        options["paper_size"] = options.pop("paper")
        is_text_with_height = file is None and lines is None and "height" in options
        if "scale" not in options and not is_text_with_height:
            options.setdefault("fit", True)
    name = None if file is None else os.fspath(file)
    drawn = None if lines is None else _copied(lines)
    return Plan(Drawing(name, drawn, json_object(options)))


def _copied(lines: Iterable[Points]) -> Lines:
    """Copies the points of all lines once, piece by piece."""
    copied = Lines()
    for at, line in enumerate(lines):
        if hasattr(line, "__array_interface__"):
            import numpy as np

            points = np.asarray(line)
            if points.ndim != 2 or points.shape[1] != 2:
                raise ValueError(f"a line has the shape {points.shape}; allowed is (n, 2)")
            copied.begin(len(points))
            for begin in range(0, len(points), _PIECE):
                copied.extend(np.ascontiguousarray(points[begin : begin + _PIECE], dtype="<f8").tobytes())
        else:
            copied.begin(0)
            try:
                pairs = iter(line)
                while piece := b"".join(_PAIR.pack(x, y) for x, y in islice(pairs, _PIECE)):
                    copied.extend(piece)
            except (TypeError, ValueError, StructError):
                raise ValueError(
                    f"lines[{at}] is {reprlib.repr(line)}; allowed is a line: an array of shape (n, 2), or pairs of x and y"
                ) from None
    return copied


def bar(completed: int, commands: int) -> None:
    """Shows the progress on the terminal, if standard error is one."""
    if sys.stderr.isatty():
        end = "\n" if completed == commands else ""
        print(f"\r{completed} of {commands} commands", end=end, file=sys.stderr, flush=True)
