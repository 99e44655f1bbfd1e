"""Programs: named points, and steps that go to them."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal, TypedDict

from ._core import Taught

ProgramProgress = Callable[[int, int, int, int | None], object]
"""Called with the step, how many there are, the cycle, and how many there are."""


class Point(TypedDict, total=False):
    """``x``, ``y`` and ``z`` (mm), with ``rotation`` (degrees) and ``frame`` if wanted; or ``base``, ``rear``,
    ``fore`` and ``servo`` (degrees)."""

    x: float
    y: float
    z: float
    rotation: float
    frame: str
    base: float
    rear: float
    fore: float
    servo: float


class Step(TypedDict, total=False):
    """A step, with the words of a program's text: one key says what it does, others say how."""

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


@dataclass(frozen=True)
class ProgramStep:
    """A step as it is done; those of a repeat at the end stand here once."""

    label: str
    """What it does."""
    file: str | None
    """The called program in which it stands; None in the program itself."""
    line: int
    """The line on which it begins, counted from 1."""
    takes_s: float
    """How long it takes the first time, in seconds."""


@dataclass(frozen=True)
class ProgramProblem:
    """Something that is wrong with a program."""

    step: int
    """The step, counted from 1 in the order in which they are done."""
    file: str | None
    """The called program in which it stands; None in the program itself."""
    line: int
    """The line on which the step begins, counted from 1."""
    label: str
    """What the step does."""
    rule: str
    """The rule of the policy, or ``arm`` where the arm itself cannot do it."""
    message: str
    """What is wrong, and what is allowed."""
    remedy: str
    """What helps."""

    def __str__(self) -> str:
        return f"step {self.step} ({self.label}): {self.message}; {self.remedy}"


@dataclass(frozen=True)
class ProgramReport:
    """What a program does, what is wrong with it, and how long it takes by the motion model."""

    steps: tuple[ProgramStep, ...]
    """Its steps, in the order in which they are done."""
    problems: tuple[ProgramProblem, ...]
    """All that is wrong; nothing where it can be done."""
    once_s: float
    """How long all of it takes once, in seconds."""
    cycle_s: float | None
    """How long a cycle takes that follows another one, in seconds; None where nothing is done again."""
    total_s: float | None
    """How long all of it takes, in seconds; None where it goes on until somebody ends it."""

    @classmethod
    def _of(cls, told: str) -> ProgramReport:
        report = json.loads(told)
        problems = [{key: it[key] for key in ProgramProblem.__annotations__} for it in report.pop("problems")]
        return cls(
            steps=tuple(ProgramStep(**it) for it in report.pop("steps")),
            problems=tuple(ProgramProblem(**it) for it in problems),
            **report,
        )


class Program:
    """A program. ``arm.run(...)`` does it; :func:`program` reads or makes one."""

    def __init__(self, taught: Taught) -> None:
        self._taught = taught

    @property
    def title(self) -> str:
        """What it calls itself, or the name of its file."""
        return self._taught.title

    @property
    def text(self) -> str:
        """Its text (TOML), as it was read."""
        return self._taught.text

    @property
    def warnings(self) -> list[str]:
        """What was surprising in a file of the vendor's program, each a sentence."""
        return self._taught.warnings

    def check(self, *, dialect: str | None = None) -> ProgramReport:
        """Looks at it for any arm as drawn, with ``specification`` or ``firmware-1.1`` as its ``dialect``.

        ``arm.check(program)`` does it for an arm where that stands. Raises :class:`ValueError` where a file that
        it names cannot be used.
        """
        return ProgramReport._of(self._taught.check(dialect))

    def save(self, file: str | os.PathLike[str]) -> list[str]:
        """Writes it, over what is there: its text (``.toml``), or its points for the vendor's program
        (``.xml``, ``.play``). Gives what that form cannot carry, each a sentence."""
        return self._taught.save(os.fspath(file))

    def __len__(self) -> int:
        return self._taught.steps

    def __repr__(self) -> str:
        return f"<Program {self.title!r}: {len(self)} steps>"


def program(
    file: str | os.PathLike[str] | None = None,
    *,
    text: str | None = None,
    steps: Sequence[Step] | None = None,
    folder: str | os.PathLike[str] = ".",
    **named: Any,
) -> Program:
    """Reads a program or makes one of its steps.

    ``file`` ends in ``.toml``, or in ``.xml`` or ``.play`` as those of the vendor's program. ``text`` is what would
    stand in a TOML file. ``steps`` are dictionaries with the words of that text, and so are ``points``, ``grids``,
    ``frames``, ``tools``, ``title`` and ``start_speed_percent``:
    ``program(points={"tray": {"x": 200, "y": 0, "z": 0}}, steps=[{"go": "tray", "suction": True}])``.
    Files that a text or steps name are in ``folder``, those that a file names are beside it.

    Raises :class:`ValueError` with the line or the step where it is no program, :class:`OSError` where
    the file cannot be read.
    """
    if [file, text, steps].count(None) != 2:
        raise TypeError("give a file, text= or steps=, and one of them only")
    if steps is None:
        if named:
            raise TypeError(f"{', '.join(named)}: these come with steps= only")
        if file is not None:
            return Program(Taught.read(os.fspath(file)))
        assert text is not None
        return Program(Taught.of_text(text, os.fspath(folder)))
    told = json.dumps({**named, "steps": list(steps)}, allow_nan=False)
    return Program(Taught.of_json(told, os.fspath(folder)))


def program_bar(step: int, steps: int, cycle: int, cycles: int | None) -> None:
    """Shows the progress of a program on the terminal, if standard error is one."""
    if sys.stderr.isatty():
        of = "" if cycles is None else f" of {cycles}"
        end = "\n" if step == steps and cycle == cycles else ""
        print(f"\rcycle {cycle}{of}, step {step} of {steps} ", end=end, file=sys.stderr, flush=True)
