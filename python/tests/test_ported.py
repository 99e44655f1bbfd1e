"""Scripts written for other packages do on a virtual arm what they were written to do.

Those in ``ported/`` are rewritten from public scripts for pydobot and its forks, with one changed import.
"""

from __future__ import annotations

import math
import re
import runpy
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest

import dobot_arm as dobot
from dobot_arm import pydobot, pydobotplus

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
    assert max(status.x_mm for status in stage.seen) == pytest.approx(first.x_mm + 20, abs=0.5)
    assert all(abs(status.z_mm - first.z_mm) < 0.5 and abs(status.y_mm) < 0.5 for status in stage.seen)
    assert "pydobot: " in capsys.readouterr().out


def test_a_block_is_carried_by_suction(stage: Stage) -> None:
    arm = stage.play("block_by_suction.py", TABLE)
    dobot.assert_object(arm, "cube", at=(200, -60), bottom_mm=0, held=False, within_mm=1)
    carried = [status for status in stage.seen if status.suction and abs(status.y_mm) < 50]
    assert carried and all(status.z_mm == pytest.approx(20, abs=0.5) for status in carried)


def test_a_gripper_goes_down_straight_and_closes(stage: Stage) -> None:
    arm = stage.play("gripper_at_rail.py", TABLE)
    last = arm.next_status()
    assert (last.x_mm, last.y_mm, last.z_mm) == pytest.approx((230, 25, 20), abs=0.5)
    assert last.gripper_deg == -90
    above = next(at for at, status in enumerate(stage.seen) if status.z_mm > 19)
    below = [status for status in stage.seen[above:] if status.z_mm < 19]
    assert min(status.z_mm for status in below) == pytest.approx(-30, abs=0.5)
    assert all(math.dist((status.x_mm, status.y_mm), (230, 25)) < 0.5 for status in below)
    assert {status.gripper_deg for status in below} == {90.0, -90.0}


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


def test_omitted_axes_and_polar_moves_for_a_uarm_reach_their_positions() -> None:
    """After the uArm's `test_move`: one coordinate at a time, in both systems."""
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(220, 0, 40)
        arm.move_to(x=200)                                       # set_position(x=200, speed=10000)
        arm.move_to(y=100)                                       # set_position(y=100)
        arm.move_to(z=60)                                        # set_position(z=60)
        assert arm.pose[:3] == pytest.approx((200, 100, 60), abs=0.1)
        arm.move_polar(reach=190)                                # set_polar(stretch=190)
        assert math.hypot(*arm.pose[:2]) == pytest.approx(190, abs=0.1)
        assert arm.joints.base_deg == pytest.approx(math.degrees(math.atan2(100, 200)), abs=0.1)
        arm.move_polar(angle=30)                                 # set_polar(rotation=120)
        assert arm.pose[:3] == pytest.approx((190 * math.cos(math.pi / 6), 95, 60), abs=0.1)
        arm.move_polar(reach=180, angle=0, z=50)                 # set_polar(stretch=180, rotation=90, height=50, wait=True)
        assert arm.pose[:3] == pytest.approx((180, 0, 50), abs=0.1)


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
    for status in path:
        assert min(far_from_line(status, a, b) for a, b in pairwise(corners)) < 0.6
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


# The public names of pydobot 1.3.2 and of its PTPMode, without the queue's private ones.
PYDOBOT = "close get_eio go grip j1 j2 j3 j4 move_to pose r set_eio speed suck verbose wait x y z"
PTP_MODES = (
    "JUMP_XYZ MOVJ_XYZ MOVL_XYZ JUMP_ANGLE MOVJ_ANGLE MOVL_ANGLE MOVJ_INC MOVL_INC MOVJ_XYZ_INC JUMP_MOVL_XYZ"
)
# The public methods of pydobotplus 0.1.2.
PYDOBOTPLUS = (
    "clear_alarms close conveyor_belt conveyor_belt_distance engrave get_alarms get_color get_hht_trig_output get_ir "
    "get_pose go_arc grip home jog_r jog_x jog_y jog_z laze move_rel move_to set_color set_hht_trig_output set_home "
    "set_io set_ir speed suck wait_for_cmd"
)


def test_all_names_of_pydobot_are_here() -> None:
    assert [mode.name for mode in pydobot.PTPMode] == PTP_MODES.split()
    with pydobot.Dobot("virtual:firmware-1.1") as device:
        for name in PYDOBOT.split():
            assert hasattr(device, name), name
        assert device.pose() == (device.x, device.y, device.z, device.r, device.j1, device.j2, device.j3, device.j4)


def test_every_name_of_pydobotplus_is_here_or_says_what_to_use() -> None:
    with pydobotplus.Dobot("virtual:firmware-1.1") as device:
        for name in PYDOBOTPLUS.split():
            try:
                assert callable(getattr(device, name)), name
            except AttributeError as error:
                assert re.search(f"'{name}': (.*device.arm|.*no such port)", str(error)), name
        with pytest.raises(AttributeError, match="'Dobot' object has no attribute 'fly'$"):
            getattr(device, "fly")
        assert device.get_pose().joints.in_radians().j2 == pytest.approx(math.radians(device.get_pose().joints.j2))
        with pytest.raises(pydobotplus.DobotException):
            device.move_to(900, 0, 0)


def test_a_move_can_be_an_increment_of_angles() -> None:
    with pydobot.Dobot("virtual:firmware-1.1") as device:
        before = device.arm.move_joints(0, 20, 30, 0)
        device.move_to(5, -2, 3, 4, wait=True, mode=pydobot.MODE_PTP.MOVJ_INC)
        base, rear, fore, servo = device.arm.joints
        assert (base, rear - before.rear_deg, fore - before.fore_deg, servo) == pytest.approx((5, -2, 3, 4), abs=0.1)


PAGE = Path(__file__).parents[2] / "docs" / "python.md"


def spans(column: int) -> list[str]:
    """The code in a column of the table for users of other packages."""
    section = PAGE.read_text().split("## From other packages")[1]
    rows = [line.strip("|").split("|") for line in section.splitlines() if line.startswith("|")]
    assert len(rows) > 12
    return [span for row in rows[2:] for span in re.findall(r"`([^`]+)`", row[column])]


def run(span: str, scope: dict[str, object]) -> None:
    """Runs a call, a keyword of a move, or the head of a block."""
    if re.match(r"\w+=", span):
        span = f"move_to(x, y, z, r, {span})"
    exec(f"{span}: pass" if span.startswith("with ") else span.replace(", ...", ""), scope)


def methods(owner: object) -> dict[str, object]:
    names = [name for name in dir(type(owner)) if not name.startswith("_")]
    return {name: getattr(owner, name) for name in names if callable(getattr(type(owner), name))}


def test_every_call_of_the_table_for_users_of_other_packages_runs(monkeypatch: pytest.MonkeyPatch) -> None:
    place = {"x": 210, "y": 10, "z": 30, "r": 0, "reach": 205, "angle": 5}
    with dobot.connect("virtual:firmware-1.1") as arm, pydobotplus.Dobot("virtual:firmware-1.1") as device:
        for span in spans(0):
            names = {"Dobot": pydobotplus.Dobot, "MODE_PTP": pydobotplus.MODE_PTP, "port": "virtual:"}
            run(span, methods(device) | place | names)
        connect = dobot.connect
        monkeypatch.setattr(dobot, "connect", lambda where: connect(where.replace("station", "virtual:")))
        for span in spans(3):
            run(span, methods(arm) | place | {"dobot": dobot, "arm": arm})
