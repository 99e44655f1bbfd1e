"""What a user of an arm relies on."""

import math
import os
import signal
import subprocess
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import dobot_arm as dobot


@pytest.fixture
def station(tmp_path: Path) -> Iterator[str]:
    """The address of a station with a virtual arm, run by the program that ``DOBOT`` names."""
    program = os.environ.get("DOBOT")
    if program is None:
        pytest.skip("the environment variable DOBOT names no `dobot` program")
    command = [
        program, "up", "--virtual", "--raw", "off",
        "--data", str(tmp_path), "--http", "127.0.0.1:0",
    ]
    with subprocess.Popen(
        command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    ) as process:
        try:
            assert process.stdout is not None
            lines = iter(process.stdout)
            address = next(
                word for line in lines for word in line.split() if word.startswith("http://")
            )
            assert any("the arm tells its state" in line for line in lines)
            yield address
        finally:
            process.terminate()


def test_a_move_returns_when_the_arm_has_arrived() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(220, 0, 20, path="movl")
        pose = arm.pose
        assert (pose.x_mm, pose.y_mm, pose.z_mm) == pytest.approx((220, 0, 20), abs=1)


def test_joint_angles_are_degrees() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_joints(30, 10, 20)
        assert arm.joints.base_deg == pytest.approx(30, abs=0.5)


def test_the_suction_cup_stays_as_it_is_unless_told_otherwise() -> None:
    with dobot.connect("virtual:") as arm:
        assert arm.move_to(220, 0, 20, suction=True).suction
        assert arm.move_to(220, 20, 20).suction
        assert not arm.move_to(220, 0, 20, suction=False).suction


@pytest.mark.parametrize("x", [900.0, math.nan, math.inf])
def test_what_the_arm_cannot_reach_is_refused_and_moves_nothing(x: float) -> None:
    with dobot.connect("virtual:") as arm:
        before = arm.status()
        with pytest.raises(dobot.Refused) as refused:
            arm.move_to(x, 0, 20)
        assert refused.value.kind
        assert arm.status() == before


def test_a_stopped_arm_moves_only_after_a_reset() -> None:
    with dobot.connect("virtual:") as arm:
        arm.stop("somebody came near")
        with pytest.raises(dobot.Refused):
            arm.move_to(220, 0, 20)
        arm.reset_stop()
        arm.move_to(220, 0, 20)


def test_an_arm_that_was_let_go_of_says_so() -> None:
    arm = dobot.connect("virtual:")
    arm.close()
    with pytest.raises(dobot.Closed):
        arm.move_to(220, 0, 20)


def test_a_place_and_a_path_that_do_not_exist_are_told_with_what_is_allowed() -> None:
    with pytest.raises(ValueError, match="virtual:"):
        dobot.connect("nowhere")
    with dobot.connect("virtual:") as arm, pytest.raises(ValueError, match="movl"):
        arm.move_to(220, 0, 20, path="straight")  # type: ignore[arg-type]


def test_a_station_that_is_not_there_is_a_lost_link() -> None:
    with pytest.raises(dobot.LinkLost):
        dobot.connect("http://127.0.0.1:1")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="this system has no fork")
def test_a_fork_may_not_use_the_arm() -> None:
    with dobot.connect("virtual:") as arm:
        child = os.fork()
        if child == 0:
            try:
                arm.stop()
            except dobot.Closed:
                os._exit(0)
            os._exit(1)
        assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0


def test_ctrl_c_stops_the_arm_of_a_station_and_is_raised(station: str) -> None:
    with dobot.connect(station) as arm, dobot.connect(station) as other:
        arm.confirm_pose()
        arm.move_to(200, -150, 60)
        signal.setitimer(signal.ITIMER_REAL, 0.1)
        previous = signal.signal(signal.SIGALRM, signal.default_int_handler)
        try:
            with pytest.raises(KeyboardInterrupt):
                arm.move_to(200, 150, 60)
        finally:
            signal.signal(signal.SIGALRM, previous)
        with pytest.raises(dobot.Refused):
            other.move_to(200, 0, 60)


def test_another_thread_stops_a_move(station: str) -> None:
    with dobot.connect(station) as arm, ThreadPoolExecutor() as threads:
        arm.confirm_pose()
        arm.move_to(200, -150, 60)
        move = threads.submit(arm.move_to, 200, 150, 60)
        arm.stop()
        with pytest.raises((dobot.Stopped, dobot.Refused)):
            move.result()


HARBOUR = Path(__file__).parents[2] / "examples" / "drawings" / "harbour.svg"


def test_a_file_is_planned_and_drawn_as_the_documentation_says() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(220, 0, 20, path="movl")
        arm.suction(True)
        assert arm.status().suction
        plan = dobot.plan(HARBOUR, paper="a5")
        assert plan.vectors > 100
        told: list[tuple[int, int]] = []
        arm.draw(plan, progress=lambda *it: told.append(it))
        assert told == sorted(told)
        completed, commands = told[-1]
        assert 100 < completed <= commands


def test_a_text_is_drawn_and_shows_itself() -> None:
    plan = dobot.plan(text="Hello", height=20)
    assert plan.title == "Hello" and plan.duration_s > 1 and plan.drawn_mm > 100
    assert plan._repr_svg_().startswith("<svg")


def test_what_cannot_be_planned_says_why() -> None:
    with pytest.raises(TypeError, match="paper_size"):
        dobot.plan(text="Hello", sheet="a5")
    with pytest.raises(TypeError, match="text="):
        dobot.plan()
    with pytest.raises(ValueError, match="height"):
        dobot.plan(text="Hello", height="tall")
    with pytest.raises(ValueError, match="JSON"):
        dobot.plan(text="Hello", height=math.nan)
    with pytest.raises(FileNotFoundError):
        dobot.plan("no-such-file.svg")


def test_a_drawing_is_stopped_by_what_its_progress_raises(station: str) -> None:
    def enough(completed: int, commands: int) -> None:
        raise RuntimeError("enough")

    with dobot.connect(station) as arm, dobot.connect(station) as other:
        arm.confirm_pose()
        arm.move_to(220, 0, -20)
        with pytest.raises(RuntimeError, match="enough"):
            arm.draw(dobot.plan(text="Hello"), progress=enough)
        with pytest.raises(dobot.Refused):
            other.move_to(200, 0, 60)
