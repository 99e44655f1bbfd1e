"""The behaviour of arms."""

import asyncio
import json
import math
import os
import signal
import subprocess
import sys
import urllib.request
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from itertools import islice, pairwise
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

import dobot_arm as dobot


def test_a_move_returns_when_the_arm_has_arrived() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(220, 0, 20, path="movl")
        pose = arm.pose
        assert (pose.x_mm, pose.y_mm, pose.z_mm) == pytest.approx((220, 0, 20), abs=1)


def test_joint_angles_are_degrees() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_joints(30, 10, 20)
        assert arm.joints.base_deg == pytest.approx(30, abs=0.5)


def test_a_move_leaves_the_suction_cup_as_it_is_by_default() -> None:
    with dobot.connect("virtual:") as arm:
        assert arm.move_to(220, 0, 20, suction=True).suction
        assert arm.move_to(220, 20, 20).suction
        assert not arm.move_to(220, 0, 20, suction=False).suction


@pytest.mark.parametrize("x", [900.0, math.nan, math.inf])
def test_an_unreachable_target_is_refused_and_nothing_moves(x: float) -> None:
    with dobot.connect("virtual:") as arm:
        before = arm.next_status()
        with pytest.raises(dobot.Refused) as refused:
            arm.move_to(x, 0, 20)
        assert refused.value.kind
        assert arm.next_status() == before


def test_a_stopped_arm_moves_only_after_a_reset() -> None:
    with dobot.connect("virtual:") as arm:
        arm.stop("somebody came near")
        with pytest.raises(dobot.Refused):
            arm.move_to(220, 0, 20)
        arm.reset_stop()
        arm.move_to(220, 0, 20)


def test_a_closed_arm_is_reported_as_closed() -> None:
    arm = dobot.connect("virtual:")
    arm.close()
    with pytest.raises(dobot.Closed):
        arm.move_to(220, 0, 20)


def test_errors_for_unknown_points_and_paths_name_the_allowed_values() -> None:
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
        assert arm.next_status().suction
        plan = dobot.plan(HARBOUR, paper="a5")
        assert plan.vectors > 100
        reported: list[tuple[int, int]] = []
        arm.draw(plan, progress=lambda *part: reported.append(part))
        assert reported == sorted(reported)
        completed, commands = reported[-1]
        assert 100 < completed <= commands


def test_a_text_is_drawn_and_shows_itself() -> None:
    plan = dobot.plan(text="Hello", height=20)
    assert plan.title == "Hello" and plan.duration_s > 1 and plan.drawn_mm > 100
    assert plan._repr_svg_().startswith("<svg")
    on_sheet = dobot.plan(text="Hello", height=20, paper="a5", landscape=True)
    assert on_sheet.drawn_mm == pytest.approx(plan.drawn_mm, rel=0.01) and on_sheet.warnings == []
    assert "scaled down to" in dobot.plan(text="Hello " * 20).warnings[0]


def test_a_text_is_drawn_below_the_file_given_with_it(tmp_path: Path) -> None:
    square = tmp_path / "square.svg"
    square.write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="30mm" height="30mm" viewBox="0 0 30 30">'
        '<rect x="5" y="5" width="20" height="20" fill="none" stroke="black"/></svg>'
    )
    alone, both = dobot.plan(square), dobot.plan(square, text="Hello")
    assert alone.drawn_mm == pytest.approx(80, abs=0.5)
    assert both.title == "square.svg" and both.drawn_mm > alone.drawn_mm + 20


def test_a_drawing_that_cannot_be_planned_gives_the_reason() -> None:
    with pytest.raises(TypeError, match="paper_size"):
        dobot.plan(text="Hello", sheet="a5")
    with pytest.raises(TypeError, match="text="):
        dobot.plan()
    with pytest.raises(TypeError, match="unknown option `heights`; did you mean `height`?"):
        dobot.plan(text="Hello", heights=20)
    wrong: list[tuple[dict[str, object], str]] = [
        ({"height": "tall"}, '^height is "tall"; allowed is a number$'),
        ({"height": math.nan}, "^height is nan; allowed is a finite number$"),
        ({"at": [210, math.inf]}, r"^at\[1\] is inf; allowed is a finite number$"),
        ({"fit": 1}, "^fit is 1; allowed is True or False$"),
        ({"text": 5}, "^text is 5; allowed is a text$"),
    ]
    for options, text in wrong:
        with pytest.raises(ValueError, match=text):
            dobot.plan(**{"text": "Hello", **options})  # type: ignore[arg-type]
    with pytest.raises(FileNotFoundError):
        dobot.plan("no-such-file.svg")


def test_an_exception_in_the_progress_callback_stops_the_drawing(station: str) -> None:
    def enough(completed: int, commands: int) -> None:
        raise RuntimeError("enough")

    with dobot.connect(station) as arm, dobot.connect(station) as other:
        arm.confirm_pose()
        arm.move_to(220, 0, -20)
        with pytest.raises(RuntimeError, match="enough"):
            arm.draw(dobot.plan(text="Hello"), progress=enough)
        with pytest.raises(dobot.Refused):
            other.move_to(200, 0, 60)


def test_a_jog_lasts_as_long_as_its_with_and_ends_at_rest() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(200, 0, 60)
        with arm.jog("y+", speed=50):
            arm.wait(1.0)
        after = arm.next_status()
        assert after.y_mm > 5
        arm.wait(1.0)
        assert arm.next_status().y_mm == pytest.approx(after.y_mm, abs=0.5)


def test_a_jog_that_is_too_long_is_released_with_an_error() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_to(200, 0, 60)
        with pytest.raises(dobot.Failed, match="at_most"):
            with arm.jog("y+", speed=20, at_most=0.5):
                arm.wait(5.0)
        first = arm.next_status().y_mm
        arm.wait(1.0)
        assert arm.next_status().y_mm == pytest.approx(first, abs=0.1)


def test_nothing_else_moves_the_arm_while_a_button_is_held() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_to(200, 0, 60)
        with arm.jog("y+"), pytest.raises(dobot.Failed, match="held"):
            arm.move_to(220, 0, 20)


def test_an_error_during_a_jog_is_raised_and_the_button_released() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_to(200, 0, 60)
        with pytest.raises(RuntimeError, match="enough"), arm.jog("y+"):
            raise RuntimeError("enough")
        arm.move_to(220, 0, 20)


def test_the_error_for_an_unknown_button_names_the_allowed_ones() -> None:
    with dobot.connect("virtual:") as arm:
        with pytest.raises(ValueError, match="base"), arm.jog("up"):  # type: ignore[arg-type]
            pass
        with pytest.raises(ValueError, match="60"), arm.jog("x+", at_most=math.nan):
            pass


def test_statuses_come_one_by_one_while_time_passes() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_to(200, 0, 60)
        with arm.jog("y+", speed=50):
            seen = [status.y_mm for status in islice(arm.statuses(), 10)]
        assert seen == sorted(seen)
        assert seen[-1] > seen[0]


def test_statuses_show_a_move_that_another_thread_makes(station: str) -> None:
    with dobot.connect(station) as arm, ThreadPoolExecutor() as threads:
        arm.confirm_pose()
        arm.move_to(200, -50, 60)
        statuses = arm.statuses()
        move = threads.submit(arm.move_to, 200, 50, 60)
        assert any(abs(status.y_mm) < 40 for status in islice(statuses, 100))
        assert not move.done()
        move.result()


def test_gripper_and_speed_reach_the_arm() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(200, 0, 60)
        arm.gripper(30)
        assert arm.next_status().gripper_deg == pytest.approx(30)
        arm.speed(20, 20)
        with pytest.raises(dobot.Refused):
            arm.speed(-5, 50)


def test_the_laser_goes_on_only_where_the_rules_allow_it(station: str) -> None:
    with dobot.connect(station) as arm:
        arm.confirm_pose()
        with pytest.raises(dobot.Refused):
            arm.laser(True)
        with pytest.raises(dobot.Refused):
            arm.arm_laser(0)
        arm.arm_laser(10)
        arm.disarm_laser()


def test_joint_angles_that_look_like_radians_are_warned_of() -> None:
    with dobot.connect("virtual:") as arm:
        with pytest.warns(UserWarning, match="radians.* 28.6 45.8 40.1"):
            try:
                arm.move_joints(0.5, 0.8, 0.7)
            except dobot.Refused:
                pass
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            arm.move_joints(30, 10, 20)


def test_points_that_look_like_metres_are_warned_of() -> None:
    with dobot.connect("virtual:") as arm:
        with pytest.warns(UserWarning, match="metres.* 220 0 50") as warned, pytest.raises(dobot.Refused):
            arm.move_to(0.22, 0, 0.05)
        assert warned[0].filename == __file__


JOGS = """
import sys
import dobot_arm as dobot
with dobot.connect(sys.argv[1]) as arm:
    arm.confirm_pose()
    arm.move_to(200, 0, 60)
    with arm.jog("y+", speed=20, at_most=60):
        print("jogs", flush=True)
        sys.stdin.read()
"""


def test_the_arm_stops_when_the_interpreter_that_jogs_it_is_killed(
    station: str, tmp_path: Path
) -> None:
    with dobot.connect(station) as watcher:
        statuses = watcher.statuses()
        with interpreter(JOGS, station, "jogs") as jogger:
            assert any(status.y_mm > 3 for status in islice(statuses, 200))
            jogger.kill()
        # The recording is written with a delay.
        assert any(jogs_sent(tmp_path)[-1] == "released" for _ in islice(statuses, 200))
        assert "y_plus" in jogs_sent(tmp_path)
        # It decelerates, and then rests.
        reported = (status.y_mm for status in islice(statuses, 200))
        ended = next((y_mm for y_mm, next_mm in pairwise(reported) if y_mm == next_mm), None)
        watcher.wait(0.5)
        assert watcher.next_status().y_mm == ended


BURNS = """
import sys
import dobot_arm as dobot
with dobot.connect(sys.argv[1]) as arm:
    arm.confirm_pose()
    arm.arm_laser(60)
    arm.laser(True)
    print("burns", flush=True)
    sys.stdin.read()
"""


def test_the_laser_goes_off_when_the_interpreter_that_burns_is_killed(station: str, tmp_path: Path) -> None:
    allow_standing_light(station)
    with dobot.connect(station) as watcher:
        statuses = watcher.statuses()
        with interpreter(BURNS, station, "burns") as burner:
            burner.kill()
        # The recording is written with a delay, and begins with the laser switched off.
        seen = (lights_sent(tmp_path) for _ in islice(statuses, 200))
        assert any("laser_on" in lights and lights[-1] == "laser_off" for lights in seen)


@contextmanager
def interpreter(script: str, station: str, says: str) -> Iterator[subprocess.Popen[str]]:
    """Another interpreter with a running script for a station."""
    command = [sys.executable, "-c", script, station]
    with subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None and process.stdout.readline() == f"{says}\n"
        yield process


def allow_standing_light(station: str) -> None:
    """Sets a policy that allows the laser while the arm stands."""
    with urllib.request.urlopen(f"{station}/api/v1/policy/text") as answer:
        text = answer.read().decode()
    allowed = text.replace("standing = false", "standing = true")
    assert allowed != text
    body = json.dumps({"text": allowed, "check": False}).encode()
    request = urllib.request.Request(
        f"{station}/api/v1/policy", body, {"content-type": "application/json"}, method="PUT"
    )
    urllib.request.urlopen(request).close()


def jogs_sent(folder: Path) -> list[str]:
    """The axes of the linear jogs in the station's recording."""
    return sent(folder, "linear_jog")


def lights_sent(folder: Path) -> list[str]:
    """The laser packets in the station's recording."""
    return [axis for axis in sent(folder, "joint_jog") if axis in ("none", "laser_on", "laser_off")]


def sent(folder: Path, kind: str) -> list[str]:
    """The axes of all packets of one kind to the arm."""
    file = max((folder / "recordings").glob("*.mcap"))
    log = subprocess.run(
        [os.environ["DOBOT"], "log", str(file), "--json"], capture_output=True, text=True, check=True
    )
    reported = [json.loads(line).get("command") for line in log.stdout.splitlines()]
    return ["none", *(command["axis"] for command in reported if command and command["type"] == kind)]


def test_coroutines_move_the_arm_and_receive_its_statuses_meanwhile() -> None:
    async def main() -> None:
        async with await dobot.aconnect("virtual:firmware-1.1") as arm:
            received: list[float] = []

            async def receive() -> None:
                async for status in arm.statuses():
                    received.append(status.y_mm)

            listener = asyncio.create_task(receive())
            await asyncio.sleep(0)
            there = await arm.move_to(200, 100, 40)
            assert there.y_mm == pytest.approx(100, abs=1)
            listener.cancel()
            assert len(received) > 5
            async with arm.jog("y-", 20):
                await arm.wait(0.5)
            assert (await arm.next_status()).y_mm < there.y_mm
            with pytest.raises(dobot.Refused):
                await arm.move_to(900, 0, 0)

    asyncio.run(main())


def test_loops_may_share_an_arm_one_after_the_other_and_at_once() -> None:
    arm = asyncio.run(dobot.aconnect("virtual:firmware-1.1"))
    there = asyncio.run(arm.move_to(200, 60, 40))
    assert there.y_mm == pytest.approx(60, abs=1)

    def in_a_loop_of_its_own(y_mm: float) -> float:
        return asyncio.run(arm.move_to(200, y_mm, 40)).y_mm

    with ThreadPoolExecutor() as threads:
        reported = list(threads.map(in_a_loop_of_its_own, (0, 30)))
    # Each waits for its own motion, or for that and the next one.
    assert {round(y_mm) for y_mm in reported} <= {0, 30}
    assert round(asyncio.run(arm.next_status()).y_mm) in (0, 30)
    asyncio.run(arm.close())


def test_a_task_that_is_cancelled_stops_the_arm(station: str) -> None:
    async def main() -> None:
        async with await dobot.aconnect(station) as arm:
            await arm.confirm_pose()
            await arm.move_to(200, -150, 60)
            with pytest.raises(asyncio.TimeoutError):
                await asyncio.wait_for(arm.move_to(200, 150, 60), 0.1)
            with pytest.raises(dobot.Refused):
                await arm.move_to(200, 0, 60)

    asyncio.run(main())


def test_the_blocking_and_the_asynchronous_arm_have_the_same_names() -> None:
    def names(kind: type) -> set[str]:
        return {name for name in vars(kind) if not name.startswith("_")}

    assert names(dobot.Arm) - {"pose", "joints", "ink", "objects"} == names(dobot.AsyncArm)


def test_the_station_that_runs_here_is_found_with_its_token(
    station: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DOBOT_DATA", str(tmp_path))
    monkeypatch.delenv("DOBOT_STATION", raising=False)
    with dobot.connect("station") as arm:
        arm.confirm_pose()


def test_a_station_that_does_not_run_is_a_lost_link(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DOBOT_DATA", str(tmp_path))
    monkeypatch.delenv("DOBOT_STATION", raising=False)
    with pytest.raises(dobot.LinkLost, match="dobot up.*DOBOT_DATA"):
        dobot.connect("station")


def test_an_arm_at_an_address_has_its_rules_and_its_watchdog_here(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    program = os.environ.get("DOBOT")
    if program is None:
        pytest.skip("the environment variable DOBOT is not set to a `dobot` program")
    monkeypatch.setenv("DOBOT_DATA", str(tmp_path))
    monkeypatch.setenv("PATH", str(Path(program).parent))
    command = [program, "arm", "--tcp", "127.0.0.1:0"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as served:
        try:
            assert served.stdout is not None
            address = next(
                word for line in served.stdout for word in line.split() if word.startswith("tcp:")
            )
            with dobot.connect(address, dialect="specification") as arm:
                arm.confirm_pose()
                assert arm.move_to(220, 0, 20).x_mm == pytest.approx(220, abs=1)
        finally:
            served.terminate()


def test_an_arm_at_an_address_is_not_used_without_a_watchdog(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(dobot.Failed, match="no watchdog"):
        dobot.connect("tcp:127.0.0.1:1")


def test_lines_of_points_are_planned_as_they_are() -> None:
    np = pytest.importorskip("numpy")
    square = [(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0), (0.0, 0.0)]
    pairs, array = dobot.plan(lines=[square]), dobot.plan(lines=[np.array(square)])
    assert pairs.drawn_mm == pytest.approx(160, abs=0.5)
    assert pairs.strokes == array.strokes
    corners = {(round(x), round(y)) for line in pairs.strokes for x, y in line}
    xs, ys = zip(*corners)
    ends = (min(xs), max(xs)), (min(ys), max(ys))
    # A long line is several vectors; each point is on the square.
    assert all(x in ends[0] or y in ends[1] for x, y in corners)
    assert max(math.dist(a, b) for a in corners for b in corners) == pytest.approx(56.57, abs=1)
    assert dobot.plan(lines=[square], text="Hello").drawn_mm > 180


@pytest.mark.skipif(not hasattr(signal, "setitimer"), reason="this system has no timer signals")
def test_ctrl_c_ends_the_planning_of_a_long_drawing() -> None:
    ticks: list[int] = []

    def interrupt(number: int, frame: object) -> None:
        # Without a check during the planning, all ticks are one, which is handled at its end.
        ticks.append(number)
        if len(ticks) == 3:
            raise KeyboardInterrupt

    def lines() -> Iterator[list[tuple[float, float]]]:
        yield [(math.cos(at / 50) * at / 4000, math.sin(at / 50) * at / 4000) for at in range(200_000)]
        signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)

    previous = signal.signal(signal.SIGALRM, interrupt)
    try:
        with pytest.raises(KeyboardInterrupt):
            dobot.plan(lines=lines())
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, previous)


SPIRAL = """
import numpy as np
import dobot_arm as dobot

def memory(name):
    # Unlike `getrusage`, this does not count the memory of the process that started this one.
    lines = open("/proc/self/status").read().splitlines()
    return next(1024 * int(line.split()[1]) for line in lines if line.startswith(name))

points = np.empty((1_000_000, 2))
for begin in range(0, len(points), 10_000):
    turn = np.linspace(begin, begin + 10_000, 10_000, endpoint=False) * (2 * np.pi / 10_000)
    radius = 5 + turn / 20
    points[begin : begin + 10_000, 0] = radius * np.cos(turn)
    points[begin : begin + 10_000, 1] = radius * np.sin(turn)
dobot.plan(lines=[points[:20_000]])
before = memory("VmRSS")
plan = dobot.plan(lines=[points])
peak = memory("VmHWM")
assert plan.drawn_mm > 10_000
print((peak - before) / points.nbytes)
"""


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux reports the current memory of a process")
def test_a_million_points_are_planned_with_two_copies_of_them() -> None:
    pytest.importorskip("numpy")
    # In a separate process, without other memory use.
    found = subprocess.run([sys.executable, "-c", SPIRAL], capture_output=True, text=True, check=True)
    # The two copies, and the planner's memory: 4.5 arrays. One more copy fails the test.
    assert float(found.stdout) < 5.4


def test_an_invalid_line_is_named_with_its_position() -> None:
    np = pytest.importorskip("numpy")
    with pytest.raises(ValueError, match=r"point 1 of line 2 is \(NaN, 0\)"):
        dobot.plan(lines=[[(0, 0), (1, 1)], [(math.nan, 0), (1, 1)]])
    with pytest.raises(ValueError, match=r"\(3,\).*\(n, 2\)"):
        dobot.plan(lines=[np.zeros(3)])
    with pytest.raises(ValueError, match="no points"):
        dobot.plan(lines=[])
    with pytest.raises(TypeError, match="lines="):
        dobot.plan(HARBOUR, lines=[[(0, 0)]])
