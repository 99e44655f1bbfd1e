"""Scripts written for other packages do on a virtual arm what they were written to do.

Those in ``ported/`` are rewritten from public scripts for pydobot and its forks, with one changed import.
"""

from __future__ import annotations

import math
import runpy
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest

import dobot_arm as dobot
from dobot_arm import pydobot

DESK = Path(__file__).parent / "scenes" / "desk.toml"
TABLE = DESK.with_name("table.toml")
SCRIPTS = Path(__file__).parent / "ported"


class Stage:
    """An arm that scripts use and that stays open after them."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.monkeypatch = monkeypatch
        self.seen: list[dobot.Status] = []
        self.arm: dobot.Arm | None = None

    def play(self, script: str, world: Path) -> dobot.Arm:
        self.arm = dobot.connect("virtual:firmware-1.1", world=world)
        take = self.arm.record()
        self.monkeypatch.setattr(pydobot, "connect", lambda *_, **__: self.arm)
        self.monkeypatch.setattr(dobot.Arm, "close", lambda arm: None)
        with take:
            runpy.run_path(str(SCRIPTS / script), run_name="__main__")
        self.monkeypatch.undo()
        self.seen = take.statuses
        return self.arm


@pytest.fixture
def stage(monkeypatch: pytest.MonkeyPatch) -> Iterator[Stage]:
    stage = Stage(monkeypatch)
    yield stage
    monkeypatch.undo()
    if stage.arm is not None:
        stage.arm.close()


def far_from_line(status: dobot.Status, a: tuple[float, float, float], b: tuple[float, float, float]) -> float:
    """The distance of a status from a line, in mm."""
    at = (status.x_mm, status.y_mm, status.z_mm)
    along = [q - p for p, q in zip(a, b)]
    share = sum((p - q) * d for p, q, d in zip(at, a, along)) / sum(d * d for d in along)
    return math.dist(at, [p + share * d for p, d in zip(a, along)])


def test_the_sample_of_pydobot_goes_forward_and_back_on_a_straight_line(
    stage: Stage, capsys: pytest.CaptureFixture[str]
) -> None:
    arm = stage.play("readme_sample.py", DESK)
    first, last = stage.seen[0], arm.next_status()
    assert (last.x_mm, last.y_mm, last.z_mm) == pytest.approx((first.x_mm, first.y_mm, first.z_mm), abs=0.5)
    assert max(it.x_mm for it in stage.seen) == pytest.approx(first.x_mm + 20, abs=0.5)
    assert all(abs(it.z_mm - first.z_mm) < 0.5 and abs(it.y_mm) < 0.5 for it in stage.seen)
    assert "pydobot: " in capsys.readouterr().out


def test_a_block_is_carried_by_suction(stage: Stage) -> None:
    arm = stage.play("block_by_suction.py", TABLE)
    dobot.assert_object(arm, "cube", at=(200, -60), bottom_mm=0, held=False, within_mm=1)
    carried = [it for it in stage.seen if it.suction and abs(it.y_mm) < 50]
    assert carried and all(it.z_mm == pytest.approx(20, abs=0.5) for it in carried)


def test_a_gripper_goes_down_straight_and_closes(stage: Stage) -> None:
    arm = stage.play("gripper_at_rail.py", TABLE)
    last = arm.next_status()
    assert (last.x_mm, last.y_mm, last.z_mm) == pytest.approx((230, 25, 20), abs=0.5)
    assert last.gripper_deg == -90
    above = next(at for at, it in enumerate(stage.seen) if it.z_mm > 19)
    below = [it for it in stage.seen[above:] if it.z_mm < 19]
    assert min(it.z_mm for it in below) == pytest.approx(-30, abs=0.5)
    assert all(math.dist((it.x_mm, it.y_mm), (230, 25)) < 0.5 for it in below)
    assert {it.gripper_deg for it in below} == {90.0, -90.0}


def test_a_script_for_pydobotplus_reaches_its_positions(stage: Stage) -> None:
    arm = stage.play("plus_small_moves.py", DESK)
    last = arm.next_status()
    assert (last.x_mm, last.y_mm, last.z_mm) == pytest.approx((230, 0, 40), abs=0.5)


def test_a_plotter_draws_its_triangle_in_one_line(stage: Stage) -> None:
    arm = stage.play("plotter.py", DESK)
    corners: list[tuple[float, float]] = [(200, -20), (240, -20), (220, 20), (200, -20)]
    dobot.assert_ink(arm, [corners])
    assert len(arm.ink) == 1


def test_a_rectangle_for_a_uarm_is_a_rectangle() -> None:
    """After the uArm's `performance_drawing`: seven positions, each with its own speed."""
    corners = [(200, 0), (230, 0), (230, 30), (200, 30), (200, 0)]
    with dobot.connect("virtual:firmware-1.1", world=DESK) as arm:
        arm.move_polar(reach=200, angle=0, z=-20)                # set_polar(stretch=200, rotation=90, height=-20)
        arm.move_to(z=-40)                                       # set_position(z=-40)
        for velocity, (x, y) in zip([30, 60, 30, 60], corners[1:]):
            arm.speed(velocity, 50)
            arm.move_to(x, y)                                    # set_position(x, y, speed=...)
        arm.move_by(z=20)                                        # set_position(z=20, relative=True)
        dobot.assert_ink(arm, [corners])


def test_relative_moves_for_an_xarm_end_where_they_began() -> None:
    """After the xArm's `1003-relative_move_line`, and its continuous moves with a radius."""
    steps = [(20, 0, 0), (0, 30, 0), (-20, 0, 0), (0, -30, 0)]
    with dobot.connect("virtual:firmware-1.1", world=DESK) as arm:
        arm.move_to(210, 0, -20)
        arm.move_to(z=-40)
        for x, y, z in steps:
            arm.move_by(x, y, z)                                 # set_position(x=..., relative=True, wait=True)
        assert arm.pose[:3] == pytest.approx((210, 0, -40), abs=0.1)
        corners = [(210, 0), (230, 0), (230, 30), (210, 30), (210, 0)]
        dobot.assert_ink(arm, [corners])


@pytest.mark.parametrize("personality", ["specification", "firmware-1.1"])
def test_a_path_is_followed_without_a_stop_in_between(personality: str) -> None:
    corners = [(200, -30, 20), (240, -10, 30), (240, 10, 30), (200, 30, 20)]
    with dobot.connect(f"virtual:{personality}") as arm:
        arm.move_to(*corners[0])
        with arm.record() as take:
            arm.follow(corners, speed=40)
        assert arm.pose[:3] == pytest.approx(corners[-1], abs=0.5)
    path = take.statuses
    for it in path:
        assert min(far_from_line(it, a, b) for a, b in pairwise(corners)) < 0.6
    moving = [math.dist((a.x_mm, a.y_mm, a.z_mm), (b.x_mm, b.y_mm, b.z_mm)) / 0.08 for a, b in pairwise(path)]
    begin = next(at for at, speed in enumerate(moving) if speed > 5)
    end = max(at for at, speed in enumerate(moving) if speed > 5)
    assert min(moving[begin : end + 1]) > 1 and max(moving) < 42


def test_a_recorded_path_is_repeated_by_its_program() -> None:
    """After the xArm's `3002-record_trajectory`: the arm is moved by a person, here by buttons."""
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(210, 0, 20)
        with arm.record() as take:
            with arm.jog("y+", speed=50):
                arm.wait(1)
            arm.suction(True)
            with arm.jog("x+", speed=50):
                arm.wait(0.5)
        end = arm.next_status()
        program = take.program("by hand", tolerance=0.5)
        assert len(program) < 12
        arm.suction(False)
        arm.move_to(210, 0, 20)
        arm.run(program, progress=None)
        again = arm.next_status()
        assert (again.x_mm, again.y_mm, again.z_mm) == pytest.approx((end.x_mm, end.y_mm, end.z_mm), abs=0.6)
        assert again.suction


def test_what_the_arm_of_2016_lacks_is_named() -> None:
    device = pydobot.Dobot("virtual:firmware-1.1")
    with pytest.raises(NotImplementedError, match="outputs"):
        device.set_eio(3, 1)
    with pytest.raises(dobot.Refused):
        device.move_to(900, 0, 0, 0, wait=True)
    before = device.pose()
    device.move_to(900, 0, 0, 0)
    with pytest.raises(dobot.Refused):
        device.move_to(220, 0, 20, 0, wait=True)
    assert device.pose() == before
    device.close()
