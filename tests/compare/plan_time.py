"""Compares the time of the Python package's `plan` with vpype's: `python tests/compare/plan_time.py`.

Needs vpype from PyPI, and the package `dobot_arm` in the module path. Both get the same numpy arrays, 100,000 points in
1,000 lines: vpype merges, sorts and simplifies them (`linemerge linesort linesimplify`); `plan` does that, searches for
a shorter order, and computes the speeds for an arm. Prints a table: processor seconds, the best of some runs of each in
turn, without reading the result, the number of points left, and the pen-up travel in mm.

Fails if `plan` takes more than twice vpype's time.
"""

from __future__ import annotations

import argparse
import math
import sys
import time
from collections.abc import Callable
from typing import Any

import numpy as np
import vpype
import vpype_cli

import dobot_arm as dobot

PX_PER_MM = 96 / 25.4
COMMANDS = "linemerge -t {tolerance}mm linesort linesimplify -t {tolerance}mm"
TOLERANCE_MM = 0.05
LIMIT = 2.0


def lines(count: int = 1000, points: int = 100) -> list[np.ndarray]:
    """Lines along a smooth field, as of wind or a magnet: 0.3 mm from point to point, beginning on 120 x 80 mm."""
    chance = np.random.default_rng(7)
    at = chance.uniform((0, 0), (120, 80), (count, 2))
    path = np.empty((points, count, 2))
    for point in path:
        point[:] = at
        x, y = at.T / 9
        angle = 2 * np.sin(x) + 2 * np.cos(1.3 * y) + x / 5
        at = at + 0.3 * np.column_stack([np.cos(angle), np.sin(angle)])
    return list(path.transpose(1, 0, 2))


def left_by_plan(plan: dobot.Plan) -> tuple[int, float]:
    """The number of vectors and the pen-up travel."""
    return plan.vectors, travel([np.array(stroke) for stroke in plan.strokes])


def sorted_by_vpype(drawn: list[np.ndarray]) -> vpype.Document:
    document = vpype.Document()
    document.add(vpype.LineCollection([PX_PER_MM * (line[:, 0] + 1j * line[:, 1]) for line in drawn]), 1)
    return vpype_cli.execute(COMMANDS.format(tolerance=TOLERANCE_MM), document)


def left_by_vpype(document: vpype.Document) -> tuple[int, float]:
    """The number of points and the pen-up travel."""
    strokes = list(document.layers[1])
    shown = [np.column_stack([stroke.real, stroke.imag]) / PX_PER_MM for stroke in strokes]
    return sum(map(len, strokes)), travel(shown)


def travel(strokes: list[np.ndarray]) -> float:
    return sum(math.dist(a[-1], b[0]) for a, b in zip(strokes, strokes[1:]))


def timed(work: Callable[[], Any]) -> tuple[float, Any]:
    begin = time.process_time()
    result = work()
    return time.process_time() - begin, result


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--runs", type=int, default=5)
    runs = arguments.parse_args().runs
    drawn = lines()
    cases: dict[str, tuple[Callable[[], Any], Callable[[Any], tuple[int, float]]]] = {
        "vpype": (lambda: sorted_by_vpype(drawn), left_by_vpype),
        "plan": (lambda: dobot.plan(lines=drawn), left_by_plan),
        "plan(tries=0)": (lambda: dobot.plan(lines=drawn, tries=0), left_by_plan),
        "plan(keep_order=True)": (lambda: dobot.plan(lines=drawn, keep_order=True), left_by_plan),
    }
    best: dict[str, tuple[float, tuple[int, float]]] = {}
    for _ in range(runs):
        for name, (work, left) in cases.items():
            seconds, result = timed(work)
            best[name] = min(best.get(name, (math.inf, (0, 0.0))), (seconds, left(result)))
    theirs = best["vpype"][0]
    for name, (seconds, (left, mm)) in best.items():
        print(f"{name:22} {seconds:7.3f} s {seconds / theirs:6.2f} times vpype's, {left:6} points or vectors, {mm:7.0f} mm of travel")
    if best["plan"][0] > LIMIT * theirs:
        sys.exit(f"plan takes more than {LIMIT} times vpype's time")


if __name__ == "__main__":
    main()
