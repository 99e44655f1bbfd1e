"""Compares plans with the time-optimal motion that toppra finds.

    cargo run --release -p dobot-examples --example benchmark_drawings -- target/drawings
    cargo build --release -p dobot-examples --example plan_json
    python tests/compare/toppra_time.py target/drawings/*.svg

needs Python with toppra and numpy (PyPI). It runs from the root of the project.

The path is the planned polygon with its corners rounded as in crates/draw/src/plan/lookahead.rs, so
that it has a curvature; the limits are the same: a speed for each way, and one acceleration, along
the path and across it together, as a polygon of 64 sides around its circle. A chain is a way
between two rests. Chains of one vector are straight lines, whose best time is known; of the others
toppra gets the longest and an even choice, and the rest counts as the planner's own look-ahead
found it, which the chosen ones check.
"""

import json
import math
import subprocess
import sys

import numpy
import toppra
import toppra.algorithm
import toppra.constraint

ACCELERATION = 100.0
DEVIATION = 0.05
WINDOW = 0.08
CHOSEN = 40
LONGEST = 400  # vectors of a chain that toppra gets: the first ones of a longer chain

toppra.setup_logging("ERROR")


def main(files):
    print("drawing, link: vectors, arm time, time-optimal, packets, ratios, peak at 80 and 20 ms, toppra / look-ahead")
    for file in files:
        free = plan(file)
        optimal = sum(chain_time(chain) for chain in free["chains"])
        checked = check(free["chains"])
        for name, it in (("without", free), ("stock", plan(file, "link"))):
            packets = 0.08 * it["vectors"]
            bound = max(optimal, packets) if name == "stock" else optimal
            print(
                f"{file} {name}: {it['vectors']}, {it['time_s']:.1f} s, {optimal:.1f} s, {packets:.1f} s, "
                f"{it['time_s'] / optimal:.4f} {it['time_s'] / bound:.4f}, "
                f"{it['peak_80_ms']:.1f} {it['peak_20_ms']:.1f}, {checked}",
                flush=True,
            )


def plan(file, *more):
    command = ["target/release/examples/plan_json", file, *more]
    return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def chain_time(chain):
    """The least time: by its own formula for a straight line, else as the look-ahead found it."""
    points = chain["points"]
    if len(points) > 2:
        return sum(point[4] for point in points[1:])
    length = math.dist(points[0][:3], points[1][:3])
    speed = min(chain["limit"], math.sqrt(ACCELERATION * length))
    return length / speed + speed / ACCELERATION


def check(chains):
    """The least and the largest share of toppra's time in the look-ahead's."""
    bent = [chain for chain in chains if len(chain["points"]) > 2]
    bent.sort(key=lambda chain: len(chain["points"]))
    step = max(1, len(bent) // CHOSEN)
    shares = [share for chain in bent[::-step] if (share := one_share(chain))]
    return f"{min(shares):.4f} to {max(shares):.4f} ({len(shares)} chains)" if shares else "all straight"


def one_share(chain):
    points = chain["points"][: LONGEST + 1]
    corners, pieces = rounded([point[:3] for point in points], chain["limit"])
    end = points[-1][3]
    found = optimum(pieces, chain["limit"], end)
    planned = sum(point[4] for point in points[1:])
    return found / planned if found else None


def rounded(points, limit):
    """Lengths and curvatures along the path, half arc, straight piece, half arc."""
    ways = [numpy.subtract(b, a) for a, b in zip(points, points[1:])]
    lengths = [numpy.linalg.norm(way) for way in ways]
    corners = [(0.0, 0.0, 0.0)]
    for (a, la), (b, lb) in zip(zip(ways, lengths), zip(ways[1:], lengths[1:])):
        turn = math.acos(max(-1.0, min(1.0, float(numpy.dot(a, b)) / (la * lb))))
        corners.append(corner(turn, 0.5 * min(la, lb)))
    corners.append((0.0, 0.0, 0.0))
    pieces = []
    for length, before, after in zip(lengths, corners, corners[1:]):
        for arc, curvature in ((before[1], before[2]), (length - before[0] - after[0], 0.0), (after[1], after[2])):
            if arc > 1e-9:
                pieces.append((arc, curvature))
    return corners, pieces


def corner(turn, most):
    """How far the arc reaches, the length of its half, its curvature."""
    if turn < 2e-7:
        return (0.0, 0.0, 0.0)
    most = min(most, DEVIATION / math.tan(turn / 4))
    seen = ACCELERATION * WINDOW * (0.5 / math.sin(turn / 2) - 0.5)
    radius = min(most / math.tan(turn / 2), max(seen * seen, 1e-6) / ACCELERATION)
    return (radius * math.tan(turn / 2), radius * turn / 2, 1.0 / radius)


class Circle(toppra.constraint.LinearConstraint):
    """The acceleration along and across the path lies in a circle; the speed is limited."""

    def __init__(self, curvatures, limit):
        super().__init__()
        self.curvatures = curvatures
        self.limit = limit
        self.identical = True

    def compute_constraint_params(self, path, gridpoints, *_):
        count = len(gridpoints)
        along = numpy.column_stack([numpy.ones(count), numpy.zeros(count)])
        across = numpy.column_stack([numpy.zeros(count), self.curvatures])
        angles = numpy.arange(64) * 2 * math.pi / 64
        sides = numpy.column_stack([numpy.cos(angles), numpy.sin(angles)])
        bounds = numpy.column_stack([numpy.zeros(count), numpy.full(count, self.limit**2)])
        return along, across, numpy.zeros((count, 2)), sides, numpy.full(64, ACCELERATION), None, bounds


class Length(toppra.interpolator.AbstractGeometricPath):
    """A path whose parameter is its length."""

    def __init__(self, length):
        self.length = length

    def __call__(self, at, order=0):
        at = numpy.asarray(at, dtype=float)
        return numpy.stack([at if order == 0 else numpy.ones_like(at) if order == 1 else 0 * at], axis=-1)

    @property
    def dof(self):
        return 1

    @property
    def path_interval(self):
        return numpy.array([0.0, self.length])


def optimum(pieces, limit, end_speed):
    """The time that toppra finds, in s."""
    grid, curvatures = [0.0], []
    for length, curvature in pieces:
        count = max(6, math.ceil(length / 0.05)) if curvature == 0.0 else 8
        start = grid[-1]
        grid.extend(start + length * (i + 1) / count for i in range(count))
        curvatures.extend([curvature] * count)
    curvatures.append(0.0)
    grid = numpy.array(grid)
    path = Length(grid[-1])
    instance = toppra.algorithm.TOPPRA([Circle(numpy.array(curvatures), limit)], path, gridpoints=grid, solver_wrapper="seidel")
    _, speeds, _ = instance.compute_parameterization(0.0, end_speed)
    if speeds is None:
        return None
    return float(numpy.sum(2 * numpy.diff(grid) / (speeds[1:] + speeds[:-1])))


if __name__ == "__main__":
    main(sys.argv[1:])
