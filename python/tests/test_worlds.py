"""Worlds, faults and serial ports of virtual arms."""

from __future__ import annotations

import math
import os
import struct
from itertools import islice
from pathlib import Path

import pytest

import dobot_arm as dobot
from dobot_arm.place import installed_program

DESK = Path(__file__).parent / "scenes" / "desk.toml"
TABLE = DESK.with_name("table.toml")
SCENES = Path(__file__).parents[2] / "examples" / "scenes"
DRAWINGS = Path(__file__).parents[2] / "examples" / "drawings"


@pytest.mark.dobot(personality="firmware-1.1", world=DESK)
def test_ink_is_where_the_plan_has_it(virtual_arm: dobot.Arm) -> None:
    plan = dobot.plan(DRAWINGS / "square.svg", pen_down=-40)
    virtual_arm.draw(plan)
    dobot.assert_ink(virtual_arm, plan, within_mm=0.5)
    drawn = sum(math.dist(a, b) for line in virtual_arm.ink for a, b in zip(line, line[1:]))
    assert drawn == pytest.approx(plan.drawn_mm, rel=0.02)


@pytest.mark.dobot(world=DESK)
def test_errors_about_ink_name_the_position_of_wrong_or_missing_ink(virtual_arm: dobot.Arm) -> None:
    dobot.assert_ink(virtual_arm, [])
    with pytest.raises(AssertionError, match="ink is expected at .* but there is no existing ink"):
        dobot.assert_ink(virtual_arm, [[(200, 0), (210, 0)]])
    virtual_arm.move_to(200, 0, -20)
    virtual_arm.move_to(200, 0, -40, path="movl")
    virtual_arm.move_to(220, 0, -40, path="movl")
    virtual_arm.move_to(220, 0, -20, path="movl")
    dobot.assert_ink(virtual_arm, [[(200, 0), (220, 0)]])
    with pytest.raises(AssertionError, match=r"there is ink at \(220.*10\.\d+ mm from the nearest expected ink"):
        dobot.assert_ink(virtual_arm, [[(200, 0), (210, 0)]], within_mm=0.5)
    with pytest.raises(AssertionError, match=r"ink is expected at \(240.*20\.\d+ mm from the nearest existing ink"):
        dobot.assert_ink(virtual_arm, [[(200, 0), (240, 0)]], within_mm=0.5)


def carry(arm: dobot.Arm) -> None:
    arm.move_to(200, 60, 10)
    arm.move_to(200, 60, -15, path="movl", suction=True, pause=0.5)
    arm.move_to(200, 60, 30, path="movl")
    arm.move_to(200, -60, 30)
    arm.move_to(200, -60, -14, path="movl", suction=False, pause=0.5)
    arm.move_to(200, -60, 30, path="movl")


@pytest.mark.dobot(personality="firmware-1.1", world=TABLE)
def test_the_position_of_a_carried_object_can_be_asserted(virtual_arm: dobot.Arm) -> None:
    dobot.assert_object(virtual_arm, "cube", at=(200, 60), bottom_mm=0, held=False)
    carry(virtual_arm)
    dobot.assert_object(virtual_arm, "cube", at=(200, -60), bottom_mm=0, held=False, within_mm=1)
    with pytest.raises(AssertionError, match=r"cube: it is at \(200\.\d+, -\d+\.\d+\), 1[12]\d\.\d+ mm from \(200, 60\)"):
        dobot.assert_object(virtual_arm, "cube", at=(200, 60))
    with pytest.raises(AssertionError, match="there is no object 'ball'; there are cube"):
        dobot.assert_object(virtual_arm, "ball")
    kinds = [event["event"] for event in virtual_arm.world().events]
    assert "picked_up" in kinds
    assert virtual_arm.world()._repr_svg_().startswith("<svg")


@pytest.mark.dobot(world=TABLE)
def test_the_held_object_is_reported(virtual_arm: dobot.Arm) -> None:
    virtual_arm.move_to(200, 60, 10)
    virtual_arm.move_to(200, 60, -15, path="movl", suction=True, pause=0.5)
    virtual_arm.move_to(200, 60, 30, path="movl")
    cube = virtual_arm.objects["cube"]
    assert cube.held and cube.bottom_mm == pytest.approx(45, abs=1) and cube.size_mm == (25, 25, 25)
    with pytest.raises(AssertionError, match="underside is 4.*the tool holds it"):
        dobot.assert_object(virtual_arm, "cube", bottom_mm=0, held=False)


def test_a_scene_file_is_read() -> None:
    with dobot.connect("virtual:", world=SCENES / "desk.toml") as arm:
        assert set(arm.objects) == {"coffee"} and arm.ink == []
    with dobot.connect("virtual:", world=str(SCENES / "desk.toml")) as arm:
        assert arm.objects["coffee"].size_mm == (70, 70, 90)
    with pytest.raises(ValueError, match="line 2: width_mm"):
        dobot.connect("virtual:", world="[pen]\nwidth_mm = -1")
    with dobot.connect("virtual:") as arm, pytest.raises(dobot.Failed, match="has no world"):
        arm.world()
    with pytest.raises(TypeError, match=r"\['drop=1%'\]"):
        dobot.connect("virtual:", faults="drop=1%")
    with pytest.raises(ValueError, match="virtual"):
        dobot.connect("http://127.0.0.1:1", faults=["drop=1%"])


@pytest.mark.dobot(personality="firmware-1.1", faults=["zero=fore:2"], world=DESK)
def test_an_arm_with_wrong_zeros_is_not_where_it_reports(virtual_arm: dobot.Arm) -> None:
    there = virtual_arm.move_to(220, 0, 20)
    truly = virtual_arm.world().state["arm"]
    assert (there.x_mm, there.z_mm) == pytest.approx((220, 20), abs=0.5)
    assert truly["fore_deg"] == pytest.approx(there.fore_deg + 2, abs=0.1)
    # 160 mm of forearm, rotated by two degrees.
    off = math.dist((truly["x_mm"], truly["z_mm"]), (there.x_mm, there.z_mm))
    assert off == pytest.approx(160 * math.radians(2), rel=0.05)


def test_faults_come_and_go() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(220, 0, 20)
        arm.set_faults("reset@1s")
        arm.wait(5)
        # After a reset the pose must be confirmed.
        with pytest.raises(dobot.Refused):
            arm.move_to(220, 40, 20)
        arm.confirm_pose()
        arm.set_faults()
        arm.move_to(220, 40, 20)
        with pytest.raises(ValueError, match="drop"):
            arm.set_faults("drop=lots")
        with pytest.raises(dobot.Failed, match="switched on"):
            arm.set_faults("zero=fore:2")


def test_the_same_seed_does_the_same() -> None:
    def time_s(seed: int) -> float:
        """The time of thirty statuses, some of which are lost."""
        with dobot.connect("virtual:firmware-1.1", world=DESK, faults=["drop=1%:from"], seed=seed) as arm:
            assert sum(1 for _ in islice(arm.statuses(), 30)) == 30
            return arm.world().time_s

    assert time_s(1) == time_s(1) != time_s(2)
    assert time_s(1) > 30 * 0.08


def packet(*floats: float) -> bytes:
    return b"\xa5" + struct.pack("<10f", *floats) + b"\x5a"


@pytest.mark.dobot(personality="firmware-1.1", world=TABLE)
def test_a_program_that_speaks_serial_moves_a_served_arm(served_arm: dobot.Served) -> None:
    serial = pytest.importorskip("serial")
    with serial.Serial(served_arm.serial, 9600, timeout=5) as port:
        reported = port.read(42 * 3)
        assert reported.count(b"\xa5") >= 1
        # MOVL to (240, 0, 0).
        port.write(packet(3, 0, 240, 0, 0, 0, 0, 1, 0, 0))
        for _ in range(200):
            port.read(42)
            if (served_arm.world.state["arm"] or {"x_mm": 0})["x_mm"] > 239:
                break
        else:
            pytest.fail("it does not arrive")
    dobot.assert_object(served_arm, "cube", at=(200, 60))


def test_any_tcp_client_can_use_a_served_arm() -> None:
    with dobot.serve("specification", speed="max") as served:
        assert served.tcp.startswith("tcp:127.0.0.1:") and served.events == []
        with pytest.raises(dobot.Failed, match="has no world"):
            served.world
    served.close()
    with pytest.raises(ValueError, match="max"):
        dobot.serve(speed="fast")


def test_an_arm_on_a_serial_port_is_moved_under_the_rules(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = os.environ.get("DOBOT")
    if program is None:
        pytest.skip("the environment variable DOBOT is not set to a `dobot` program")
    monkeypatch.setenv("DOBOT_DATA", str(tmp_path))
    monkeypatch.setenv("PATH", str(Path(program).parent))
    with dobot.serve("firmware-1.1", world=TABLE, speed=10) as served:
        with dobot.connect(f"serial:{served.serial}", dialect="firmware-1.1") as arm:
            arm.confirm_pose()
            assert arm.move_to(220, 40, 20).y_mm == pytest.approx(40, abs=0.5)
            with pytest.raises(dobot.Refused):
                arm.move_to(200, 0, -90)
        true = served.world.state["arm"]
        assert (true["x_mm"], true["y_mm"], true["z_mm"]) == pytest.approx((220, 40, 20), abs=0.5)
        assert served.events == []


def test_the_program_of_a_wheel_is_found_wherever_it_was_installed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    info = tmp_path / "dobot_arm-9.dist-info"
    info.mkdir()
    (info / "METADATA").write_text("Metadata-Version: 2.1\nName: dobot-arm\nVersion: 9\n")
    (info / "RECORD").write_text("bin/dobot,,\n")
    monkeypatch.syspath_prepend(tmp_path)
    assert installed_program() is None, "it is only listed"
    program = tmp_path / "bin" / "dobot"
    program.parent.mkdir()
    program.touch()
    assert installed_program() == str(program)
