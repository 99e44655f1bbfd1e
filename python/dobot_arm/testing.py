"""Assertions on the effects of a virtual arm on its world."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from ._core import ink_deviation
from .arm import Arm
from .drawing import Plan
from .served import Served
from .world import World

Expected = Plan | Sequence[Sequence[tuple[float, float]]]
"""A plan, or lines of points: x and y in the base frame, in mm."""


def assert_ink(seen: Arm | Served | World, expected: Expected, *, within_mm: float = 0.5) -> None:
    """Asserts that there is ink where it is expected and nowhere else, both within this many millimetres.

    Raises :class:`AssertionError` with the positions of the largest deviations.
    """
    drawn = _world(seen).ink
    wanted = expected.strokes if isinstance(expected, Plan) else expected
    if not drawn and not wanted:
        return
    astray, missed = ink_deviation(_tuples(wanted), drawn)
    found = []
    if astray[2] > within_mm:
        found.append(f"there is ink at {_place(astray)}, {_far(astray, 'expected ink')}")
    if missed[2] > within_mm:
        found.append(f"ink is expected at {_place(missed)}, {_far(missed, 'existing ink')}")
    if found:
        raise AssertionError(f"{'; '.join(found)}; allowed are {within_mm} mm")


def assert_object(
    seen: Arm | Served | World,
    name: str,
    *,
    at: tuple[float, float] | None = None,
    bottom_mm: float | None = None,
    held: bool | None = None,
    within_mm: float = 1.0,
) -> None:
    """Asserts the state of an object: ``at`` is its centre (x and y, mm), ``bottom_mm`` the height of its
    underside above the table, ``held`` whether it moves with the tool. Omitted values are not checked.

    Raises :class:`AssertionError` with all differences.
    """
    objects = _world(seen).objects
    if name not in objects:
        raise AssertionError(f"there is no object {name!r}; there are {', '.join(objects) or 'none'}")
    found_object = objects[name]
    found = []
    if at is not None:
        off_mm = math.dist(at, (found_object.x_mm, found_object.y_mm))
        if off_mm > within_mm:
            found.append(f"it is at ({found_object.x_mm:.2f}, {found_object.y_mm:.2f}), {off_mm:.2f} mm from ({at[0]:g}, {at[1]:g})")
    if bottom_mm is not None and abs(found_object.bottom_mm - bottom_mm) > within_mm:
        found.append(f"its underside is {found_object.bottom_mm:.2f} mm above the table, not {bottom_mm:g}")
    if held is not None and found_object.held != held:
        found.append("the tool holds it" if found_object.held else "the tool does not hold it")
    if found:
        raise AssertionError(f"{name}: {'; '.join(found)}; allowed are {within_mm} mm")


def _world(seen: Arm | Served | World) -> World:
    if isinstance(seen, World):
        return seen
    return seen.world if isinstance(seen, Served) else seen.world()


def _tuples(lines: Iterable[Iterable[tuple[float, float]]]) -> list[list[tuple[float, float]]]:
    return [[(float(x), float(y)) for x, y in line] for line in lines]


def _place(found: tuple[float, float, float]) -> str:
    return f"({found[0]:.2f}, {found[1]:.2f})"


def _far(found: tuple[float, float, float], other: str) -> str:
    if math.isinf(found[2]):
        return f"but there is no {other}"
    return f"{found[2]:.2f} mm from the nearest {other}"
