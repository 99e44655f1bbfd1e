"""The packets of the command line in Python: mouse, voice, hand, vectors and settings."""

import asyncio
import json
import os
import subprocess
from collections.abc import Callable
from itertools import islice
from pathlib import Path

import pytest

import dobot_arm as dobot


def test_a_mouse_moves_by_a_distance_and_keeps_the_tool() -> None:
    with dobot.connect("virtual:specification") as arm:
        arm.move_to(220, 0, 40, 30)
        there = arm.mouse(5, -4, 3, suction=True)
        assert position(there) == pytest.approx((225, -4, 43), abs=0.1)
        assert there.rotation_deg == pytest.approx(30, abs=0.1)
        assert there.suction
        assert arm.mouse(0, 4, 0, rotation=10).rotation_deg == pytest.approx(10, abs=0.1)


def test_a_mouse_on_an_arm_as_sold_keeps_the_servo() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_joints(20, 45, 45, 15)
        there = arm.mouse(10, 4, 0)
        assert there.servo_deg == pytest.approx(15, abs=0.1)
        assert there.base_deg < 20


@pytest.mark.parametrize("personality", ["specification", "firmware-1.1"])
def test_a_spoken_order_is_carried_out(personality: str) -> None:
    with dobot.connect(f"virtual:{personality}") as arm:
        arm.move_to(220, 0, 40)
        assert position(arm.say("go left ten")) == pytest.approx((220, 10, 40), abs=0.1)
        assert arm.say("catch").suction
        assert not arm.say("release").suction


def test_words_without_an_order_are_refused_with_an_example() -> None:
    with dobot.connect("virtual:") as arm:
        with pytest.raises(ValueError, match="left ten"):
            arm.say("left")
        with pytest.raises(ValueError, match="ahead"):
            arm.say("hello")


def test_the_arm_follows_a_hand_and_grabs_when_it_closes() -> None:
    with dobot.connect("virtual:specification") as arm:
        there = arm.hand(230, 20, 40)
        assert position(there) == pytest.approx((230, 20, 40), abs=0.1)
        assert not there.suction
        assert arm.hand(230, 20, 30, grab=True).suction
        assert arm.hand(230, 0, 30).suction


@pytest.mark.parametrize("personality", ["specification", "firmware-1.1"])
def test_a_vector_is_a_distance_in_every_dialect(personality: str) -> None:
    with dobot.connect(f"virtual:{personality}") as arm:
        arm.move_to(220, 0, 40)
        there = arm.vector(6, 20, -3, speed=40)
        assert position(there) == pytest.approx((226, 20, 37), abs=0.3)


def test_a_vector_burns_only_with_an_armed_laser(station: str) -> None:
    with dobot.connect(station) as arm:
        arm.confirm_pose()
        before = arm.move_to(220, 0, 40)
        with pytest.raises(dobot.Refused, match="laser"):
            arm.vector(0, 20, 0, burn=True)
        assert arm.next_status() == before
        arm.arm_laser(60)
        assert arm.vector(0, 20, 0, burn=True).y_mm == pytest.approx(20, abs=0.3)


def test_targets_of_all_commands_keep_the_rules() -> None:
    out_of_reach: list[Callable[[dobot.Arm], object]] = [
        lambda arm: arm.mouse(500, 0, 0),
        lambda arm: arm.say("ahead nine hundred"),
        lambda arm: arm.hand(900, 0, 0),
        lambda arm: arm.vector(0, 0, 900),
    ]
    with dobot.connect("virtual:specification") as arm:
        before = arm.move_to(220, 0, 40)
        for command in out_of_reach:
            with pytest.raises(dobot.Refused):
                command(arm)
        assert arm.next_status() == before


def test_a_jog_has_the_configured_speed() -> None:
    def jogged_mm(linear_speed: float) -> float:
        with dobot.connect("virtual:specification") as arm:
            arm.move_to(220, 0, 40)
            arm.set_jog(linear_speed=linear_speed, linear_acceleration=200)
            with arm.jog("y+", speed=100):
                arm.wait(1.0)
            return arm.next_status().y_mm

    # Trapezoids with the same ramps: 60 mm/s, and 20 mm/s.
    assert jogged_mm(60) > 2.5 * jogged_mm(20)


def test_jumps_and_moves_have_the_configured_height_and_speed() -> None:
    def seen(joint_speed: float, jump_height: float) -> list[float]:
        """The heights during a jump."""

        async def main() -> list[float]:
            async with await dobot.aconnect("virtual:specification") as arm:
                await arm.move_to(220, -60, 40)
                await arm.speed(100, 100)
                await arm.set_moves(
                    joint_speed=joint_speed, linear_speed=joint_speed, jump_height=jump_height
                )
                heights: list[float] = []

                async def watch() -> None:
                    async for status in arm.statuses():
                        heights.append(status.z_mm)

                watcher = asyncio.create_task(watch())
                await asyncio.sleep(0)
                await arm.jump(220, 60, 40)
                watcher.cancel()
                return heights

        return asyncio.run(main())

    fast, slow = seen(100, 20), seen(20, 35)
    assert max(fast) == pytest.approx(60, abs=1)
    assert max(slow) == pytest.approx(75, abs=1)
    assert len(slow) > 2 * len(fast)


def test_a_vector_has_the_configured_acceleration() -> None:
    def statuses_of_a_vector(acceleration: float) -> int:
        async def main() -> int:
            async with await dobot.aconnect("virtual:specification") as arm:
                await arm.move_to(220, -40, 40)
                await arm.set_writing(acceleration=acceleration)
                seen: list[float] = []

                async def watch() -> None:
                    async for status in arm.statuses():
                        seen.append(status.y_mm)

                watcher = asyncio.create_task(watch())
                await asyncio.sleep(0)
                await arm.vector(0, 80, 0, speed=80)
                watcher.cancel()
                return len(seen)

        return asyncio.run(main())

    # 80 mm from rest to rest: 1.8 s at 100 mm/s2, 5.7 s at 10 mm/s2; a status each 80 ms.
    assert statuses_of_a_vector(10) > 2 * statuses_of_a_vector(100)


def test_the_angles_of_the_arm_are_as_they_are_set() -> None:
    with dobot.connect("virtual:specification") as arm:
        arm.set_angles(30, 20)
        joints = arm.joints
        assert (joints.base_deg, joints.rear_deg, joints.fore_deg) == pytest.approx((0, 30, 20), abs=0.1)


def test_the_pose_is_that_of_the_tool_that_is_set() -> None:
    with dobot.connect("virtual:specification") as arm:
        before = arm.move_joints(0, 45, 45)
        arm.set_tool("laser")
        # The laser is mounted 5.5 mm nearer to the wrist than the suction cup, and 2 mm shorter.
        assert before.x_mm - arm.pose.x_mm == pytest.approx(5.5, abs=0.01)
        with pytest.raises(ValueError, match="suction-cup"):
            arm.set_tool("hammer")  # type: ignore[arg-type]


def test_settings_that_make_no_sense_are_refused() -> None:
    with dobot.connect("virtual:") as arm:
        with pytest.raises(dobot.Refused):
            arm.set_jog(joint_speed=0)
        with pytest.raises(dobot.Refused):
            arm.set_moves(jump_height=-1)
        with pytest.raises(dobot.Refused):
            arm.set_writing(acceleration=-10)


def test_python_sends_what_the_command_line_sends(station: str, tmp_path: Path) -> None:
    pairs: list[tuple[Callable[[dobot.Arm], object], str]] = [
        (lambda arm: arm.mouse(5, -2.5, 3, suction=True), "mouse 5 -2.5 3 --suction on"),
        (lambda arm: arm.hand(230, 20, 40, grab=False), "hand 230 20 40 --grab off"),
        (lambda arm: arm.say("left ten"), "say left ten"),
        (
            lambda arm: arm.vector(0, -20, 0, speed=30, start_speed=1, end_speed=2),
            "vector 0 -20 0 --speed 30 --start-speed 1 --end-speed 2",
        ),
        (lambda arm: arm.set_jog(), "set jog"),
        (lambda arm: arm.set_jog(servo_speed=40), "set jog --servo-speed 40"),
        (lambda arm: arm.set_moves(), "set moves"),
        (lambda arm: arm.set_moves(jump_height=30, pause=1), "set moves --jump-height 30 --pause 1"),
        (lambda arm: arm.set_writing(), "set writing"),
        (lambda arm: arm.set_tool("laser"), "set tool laser"),
        (lambda arm: arm.speed(), "set percent"),
        (lambda arm: arm.set_angles(45, 45), "set angles 45 45"),
    ]
    start = "move 220 0 40 --rotation 0"
    with dobot.connect(station) as arm:
        arm.confirm_pose()
        arm.jump(220, 0, 40, 0)
        for call, _ in pairs:
            call(arm)
        arm.confirm_pose()
        arm.set_tool("suction-cup")
    for words in ["confirm", start, *(words for _, words in pairs)]:
        dobot_program(f"{words} --station {station}")
    wanted = len(pairs) + 1
    commands = commands_sent(tmp_path)
    with dobot.connect(station) as arm:
        # The recording is written with a delay.
        for _ in islice(arm.statuses(), 100):
            if len(commands) >= 2 * wanted + 1:
                break
            commands = commands_sent(tmp_path)
    assert commands[:wanted] == commands[wanted + 1 :]


def dobot_program(words: str) -> None:
    subprocess.run([os.environ["DOBOT"], *words.split()], check=True, capture_output=True, text=True)


def commands_sent(folder: Path) -> list[object]:
    """The packets to the arm in the station's recording, without releases of buttons."""
    file = max((folder / "recordings").glob("*.mcap"))
    log = subprocess.run(
        [os.environ["DOBOT"], "log", str(file), "--json"], capture_output=True, text=True, check=True
    )
    commands = [json.loads(line).get("command") for line in log.stdout.splitlines()]
    return [command for command in commands if command and not command["type"].endswith("_jog")]


def position(status: dobot.Status) -> tuple[float, float, float]:
    return (status.x_mm, status.y_mm, status.z_mm)
