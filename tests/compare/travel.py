"""Compares the order of strokes with vpype's and LKH's: `python tests/compare/travel.py`.

Needs vpype and elkai from PyPI, and runs from the project's root. Makes the benchmark drawings,
lets vpype (`linesort --two-opt`, with and without `linemerge`) and the example `order_drawings` put
their strokes in order, and prints a table: pen-up travel between the strokes in mm, and processor
seconds for the ordering alone, without reading the file. LKH solves the dots as a round trip; the
longest way of it is left out. `--quick` leaves LKH out, `--lkh SECONDS` sets how long it searches.

Fails where a travel is longer than vpype's or took more than a twentieth of its time.
"""

import argparse
import json
import math
import re
import subprocess
import sys
import time
from pathlib import Path

import numpy
import vpype
import vpype_cli

FOLDER = Path("target/drawings")
DRAWINGS = [
    f"{name}{order}"
    for name in ["hilbert", "spirograph", "text", "stipple", "hatch"]
    for order in ["", "-shuffled"]
]
RIVALS = ["linesort --two-opt", "linemerge linesort --two-opt", "linemerge linesort reloop"]
TWO_OPT = RIVALS[0]
KICKS = [0, 500, 30_000]
SEEDS = [1, 2, 3]
PX_PER_MM = 96 / 25.4


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("--quick", action="store_true", help="leave LKH out")
    arguments.add_argument("--lkh", type=int, default=300, metavar="SECONDS")
    arguments = arguments.parse_args()

    cargo_example("benchmark_drawings", str(FOLDER))
    ours = {kicks: ordered(kicks) for kicks in KICKS}
    failures = []
    for name in DRAWINGS:
        print(f"\n{name}")
        theirs = {command: sorted_by_vpype(command, name) for command in RIVALS}
        for command, (travel, seconds) in theirs.items():
            print(f"  vpype {command:29} {travel:10.1f} mm {seconds:9.4f} s")
        travel, seconds = theirs[TWO_OPT]
        for kicks in KICKS:
            runs = ours[kicks][name]
            longest = max(run["travel"] for run in runs)
            slowest = max(run["order_s"] for run in runs)
            ratio = f"{longest / travel:6.3f}" if travel > 0 else "     -"
            print(
                f"  dobot, {kicks:6} kicks{'':18} {longest:10.1f} mm {slowest:9.4f} s"
                f"   {ratio} of the travel, {slowest / max(seconds, 1e-9):6.4f} of the time"
            )
        # One stroke alone takes both no time at all: there is nothing to compare.
        kept = [k for k in KICKS if beats(ours[k][name], travel, seconds)]
        if seconds > 0.001 and not kept:
            failures.append(name)
    if not arguments.quick:
        compare_with_lkh(ours, arguments.lkh)
    if failures:
        sys.exit(f"longer or slower than vpype's linesort --two-opt: {', '.join(failures)}")


def beats(runs, travel, seconds):
    """Whether every seed travels no further, in a twentieth of the time."""
    return all(
        run["travel"] <= travel + 0.001 and run["order_s"] <= seconds / 20 for run in runs
    )


def ordered(kicks):
    """For each drawing what `order_drawings` found, once for each seed."""
    files = [str(FOLDER / f"{name}.svg") for name in DRAWINGS]
    found = {name: [] for name in DRAWINGS}
    for seed in SEEDS:
        lines = cargo_example("order_drawings", "length", str(kicks), str(seed), *files)
        for line in lines.splitlines():
            run = json.loads(line)
            found[Path(run["file"]).stem].append(run)
    return found


def cargo_example(name, *arguments):
    command = ["cargo", "run", "-q", "--release", "-p", "dobot-examples", "--example", name, "--"]
    return subprocess.run([*command, *arguments], check=True, text=True, stdout=subprocess.PIPE).stdout


def sorted_by_vpype(command, name):
    """Travel in mm and processor seconds of a vpype command, run in this process."""
    document = vpype.Document()
    document.add(lines_of(name), 1)
    begin = time.process_time()
    lines = vpype_cli.execute(command, document).layers[1]
    seconds = time.process_time() - begin
    return lines.pen_up_length()[0] / PX_PER_MM, seconds


def lines_of(name):
    """The strokes of a drawing; vpype itself reads no dots."""
    file = FOLDER / f"{name}.svg"
    if name.startswith("stipple"):
        dots = [complex(x, y) * PX_PER_MM for x, y in dots_of(file)]
        return vpype.LineCollection([numpy.array([dot, dot]) for dot in dots])
    return vpype.read_svg(str(file), quantization=0.05 * PX_PER_MM)[0]


def dots_of(file):
    found = re.findall(r'd="M([\d.]+) ([\d.]+)h0"', file.read_text())
    return [(float(x), float(y)) for x, y in found]


def compare_with_lkh(ours, seconds):
    dots = dots_of(FOLDER / "stipple.svg")
    best = lkh(dots, seconds)
    print(f"\nstipple, LKH for {seconds} s: {best:.1f} mm")
    for kicks, found in ours.items():
        for run in found["stipple-shuffled"]:
            print(
                f"  dobot, {kicks:6} kicks {run['travel']:10.1f} mm {run['order_s']:9.4f} s"
                f"   {run['travel'] / best:6.4f} of LKH's"
            )


def lkh(dots, seconds):
    """The length of LKH's round trip without its longest way, in mm."""
    # elkai's public functions take no time limit, and would search for most of an hour.
    from elkai import _elkai

    head = f"NAME: dots\nTYPE: TSP\nDIMENSION: {len(dots)}\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n"
    # LKH rounds ways to whole numbers: count in micrometres.
    body = "".join(f"{i} {1000 * x:.0f} {1000 * y:.0f}\n" for i, (x, y) in enumerate(dots, 1))
    settings = f"RUNS = 1\nTIME_LIMIT = {seconds}\nTRACE_LEVEL = 0\nPROBLEM_FILE = :stdin:\n"
    tour = _elkai.solve_problem(settings, f"{head}{body}EOF\n")
    ways = [math.dist(dots[a - 1], dots[b - 1]) for a, b in zip(tour, tour[1:] + tour[:1])]
    return sum(ways) - max(ways)


if __name__ == "__main__":
    main()
