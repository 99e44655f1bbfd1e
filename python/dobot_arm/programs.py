"""Taught programs: named points, and steps that move to them."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, NamedTuple, TypedDict

from ._core import Taught
from .values import json_object

ProgramProgress = Callable[[int, int, int, int | None], object]
"""Called with the step, the number of steps, the cycle, and the number of cycles."""


@dataclass(frozen=True)
class Question:
    """A question of a running program."""

    text: str
    """The question."""
    answers: tuple[str, ...]
    """The possible answers; empty if it asks for a position."""
    place: str | None
    """The name of the position that it asks for; None if it asks for one of the answers."""
    by: Literal["person", "seen"]
    """Who may answer: only a person, or also a camera or another program."""

    @classmethod
    def _of(cls, text: str) -> Question:
        asked = json.loads(text)
        if asked["asks"] == "place":
            name = asked["name"]
            return cls(text=f"Where is {name}?", answers=(), place=name, by="seen")
        return cls(text=asked["text"], answers=tuple(asked["answers"]), place=None, by=asked["by"])


class SeenPosition(NamedTuple):
    """A position that a camera has located, as an answer; marked as such in the log and on the page."""

    x_mm: float
    """Ahead of the base's axis, in mm."""
    y_mm: float
    """To the left of the base's axis, in mm."""
    z_mm: float
    """Above the rear arm's pivot, in mm."""
    turn_deg: float = 0.0
    """The rotation of the tool, in degrees."""


Ask = Callable[[Question], str | Sequence[float]]
"""Called with a question; returns one of its answers, or x, y, z (mm) and optionally the rotation (degrees)."""


_From = TypedDict("_From", {"from": str}, total=False)
_While = TypedDict("_While", {"while": str}, total=False)


class Point(_From, total=False):
    """``x``, ``y`` and ``z`` (mm), optionally with ``rotation`` (degrees) and ``frame``; or ``base``, ``rear``,
    ``fore`` and ``servo`` (degrees). In ``go``, ``pick`` and ``place`` also ``from``, the name of a position that
    is given while the program runs, with ``timeout`` (seconds) and ``otherwise``; ``from`` ``"seen"`` with
    ``marker``, where a camera sees it.
    """

    x: float
    y: float
    z: float
    rotation: float
    frame: str
    base: float
    rear: float
    fore: float
    servo: float
    marker: int
    timeout: float
    otherwise: Literal["pause", "skip"]


class Step(_While, total=False):
    """A step, with the keys of a program's text: one key is the action, others are its parameters."""

    go: str | Point
    path: Literal["jump", "movl", "movj"]
    offset: Mapping[str, float]
    suction: bool
    gripper: float
    pause: float
    laser: bool
    wait: str
    barrier: str
    speed: Mapping[str, float]
    tool: str
    repeat: int | Literal["forever"]
    each: str | Sequence[str]
    steps: Sequence[Step]
    call: str
    arc: Mapping[str, object]
    circle: Mapping[str, object]
    drawing: Mapping[str, object]
    choose: str
    by: Literal["person", "seen"]
    every: int
    timeout: float
    otherwise: str
    when: Sequence[Mapping[str, object]]
    set: Mapping[str, int]
    add: Mapping[str, int]
    pick: str | Point
    place: str | Point
    approach: float
    retreat: float
    settle: float
    on_missed: Mapping[str, object]


@dataclass(frozen=True)
class ProgramStep:
    """A step in execution order; the steps of a final repeat are listed once."""

    label: str
    """Its description."""
    file: str | None
    """The called program that contains it; None for the program itself."""
    line: int
    """The line on which it begins, counted from 1."""
    takes_s: float
    """Its duration the first time, in seconds."""


@dataclass(frozen=True)
class ProgramProblem:
    """A problem of a program."""

    step: int
    """The step, counted from 1 in execution order."""
    file: str | None
    """The called program that contains it; None for the program itself."""
    line: int
    """The line on which the step begins, counted from 1."""
    label: str
    """The description of the step."""
    rule: str
    """The rule of the policy, or ``arm`` for a limit of the arm itself."""
    message: str
    """The problem, and what is allowed."""
    remedy: str
    """The remedy."""

    def __str__(self) -> str:
        return f"step {self.step} ({self.label}): {self.message}; {self.remedy}"


@dataclass(frozen=True)
class ProgramReport:
    """The steps, problems and durations of a program, by the motion model."""

    steps: tuple[ProgramStep, ...]
    """Its steps, in execution order."""
    problems: tuple[ProgramProblem, ...]
    """All problems; empty if the program can be run."""
    once_s: float | None
    """The duration of the first pass through all steps, in seconds, from the current position of the arm; None
    if there are problems."""
    cycle_s: float | None
    """The duration of each further cycle, in seconds; None if nothing is repeated or there are problems."""
    total_s: float | None
    """The total duration, in seconds; None for endless programs or if there are problems."""
    depends_on_answers: bool
    """Whether the program asks: then steps and durations are those with the first answer to each question."""

    @classmethod
    def _of(cls, text: str) -> ProgramReport:
        report = json.loads(text)
        problems = [{key: problem[key] for key in ProgramProblem.__annotations__} for problem in report.pop("problems")]
        return cls(
            steps=tuple(ProgramStep(**step) for step in report.pop("steps")),
            problems=tuple(ProgramProblem(**problem) for problem in problems),
            **report,
        )


class Program:
    """A program. ``arm.run(...)`` runs it; :func:`program` reads or creates one."""

    def __init__(self, taught: Taught) -> None:
        self._taught = taught

    @property
    def title(self) -> str:
        """Its title, or the name of its file."""
        return self._taught.title

    @property
    def text(self) -> str:
        """Its text (TOML), as it was read."""
        return self._taught.text

    @property
    def warnings(self) -> list[str]:
        """Unexpected contents of a file of the vendor's software, a sentence each."""
        return self._taught.warnings

    def check(self, *, dialect: str | None = None) -> ProgramReport:
        """Checks the program for a nominal arm with the ``dialect`` ``specification`` or ``firmware-1.1``.

        ``arm.check(program)`` checks it for an arm at its current position. Raises :class:`ValueError` if a
        file that the program uses cannot be read.
        """
        return ProgramReport._of(self._taught.check(dialect))

    def save(self, file: str | os.PathLike[str]) -> list[str]:
        """Writes the program, replacing an existing file: its text (``.toml``), or its points for the vendor's
        software (``.xml``, ``.play``), with the joint angles of positions. Returns what that format cannot
        represent, a sentence each. Raises :class:`ValueError` if a position is out of reach.
        """
        return self._taught.save(os.fspath(file))

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, self._taught.parts()

    def __len__(self) -> int:
        return self._taught.steps

    def __repr__(self) -> str:
        return f"<Program {self.title!r}: {len(self)} steps>"


def _restored(*parts: Any) -> Program:
    return Program(Taught.of_parts(*parts))


def program(
    file: str | os.PathLike[str] | None = None,
    *,
    text: str | None = None,
    steps: Sequence[Step] | None = None,
    folder: str | os.PathLike[str] = ".",
    **named: Any,
) -> Program:
    """Reads a program, or creates one from its steps.

    ``file`` ends in ``.toml``, or in ``.xml``, ``.play`` or ``.playback`` for files of the vendor's software. ``text`` is the
    contents of a TOML file. ``steps`` are dictionaries with the keys of that text, and so are ``points``,
    ``grids``, ``frames``, ``tools``, ``variables``, ``title`` and ``start_speed_percent``: ``program(points={"tray":
    {"x": 200, "y": 0, "z": 0}}, steps=[{"go": "tray", "suction": True}])``. Files used by a text or by steps are
    in ``folder``, those used by a file are next to it.

    Raises :class:`ValueError` with the line or the step if it is not a valid program, :class:`OSError` if the
    file cannot be read.
    """
    if [file, text, steps].count(None) != 2:
        raise TypeError("give exactly one of file, text= and steps=")
    if steps is None:
        if named:
            raise TypeError(f"{', '.join(named)}: allowed only with steps=")
        if file is not None:
            return Program(Taught.read(os.fspath(file)))
        assert text is not None
        return Program(Taught.of_text(text, os.fspath(folder)))
    document = json_object({**named, "steps": list(steps)})
    return Program(Taught.of_json(document, os.fspath(folder)))


def program_bar(step: int, steps: int, cycle: int, cycles: int | None) -> None:
    """Shows the progress of a program on the terminal, if standard error is one."""
    if sys.stderr.isatty():
        of = "" if cycles is None else f" of {cycles}"
        end = "\n" if step == steps and cycle == cycles else ""
        print(f"\rcycle {cycle}{of}, step {step} of {steps} ", end=end, file=sys.stderr, flush=True)
