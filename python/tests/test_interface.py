"""What people and tools see of the package: signatures, errors, names, and what a station knows."""

from __future__ import annotations

import asyncio
import copy
import inspect
import math
import pickle
import pydoc
from collections.abc import Callable
from itertools import islice
from pathlib import Path

import pytest

import dobot_arm as dobot
from dobot_arm import operations

OPERATIONS = [name for name, value in vars(operations.Connection).items() if isinstance(value, operations.operation)]


def public(owner: type) -> list[str]:
    return [name for name in dir(owner) if not name.startswith("_")]


@pytest.mark.parametrize("owner", [dobot.Arm, dobot.AsyncArm])
def test_help_of_an_operation_shows_its_arguments_and_its_result(owner: type) -> None:
    assert len(OPERATIONS) > 30
    for name in OPERATIONS:
        method, begin = getattr(owner, name), vars(operations.Connection)[name].begin
        signature, declared = inspect.signature(method), inspect.signature(begin)
        assert list(signature.parameters) == list(declared.parameters) and "self" in signature.parameters
        assert f"Operation[{signature.return_annotation}]" == declared.return_annotation
        assert inspect.iscoroutinefunction(method) == (owner is dobot.AsyncArm)
        assert method.__doc__ and method.__qualname__ == f"{owner.__name__}.{name}"
        help_text = pydoc.plain(pydoc.render_doc(method))
        assert "Operation[" not in help_text and f"-> '{signature.return_annotation}'" in help_text


def test_every_public_name_has_a_documentation_and_a_signature() -> None:
    for name in dobot.__all__:
        assert name in dir(dobot)
        value = getattr(dobot, name)
        if inspect.isfunction(value):
            shown = str(inspect.signature(value))
            assert value.__doc__ and "Core" not in shown and "->" in shown, name
        elif inspect.isclass(value) and value.__module__.startswith("dobot_arm"):
            assert value.__doc__, name
            for member in public(value):
                found = inspect.getattr_static(value, member)
                if inspect.isfunction(found) and found.__module__.startswith("dobot_arm"):
                    assert found.__doc__, f"{name}.{member}"
                    parameters = list(inspect.signature(found).parameters.values())
                    assert all(one.annotation is not one.empty for one in parameters[1:]), f"{name}.{member}"
    assert inspect.signature(dobot.connect).return_annotation == "Arm"
    assert inspect.signature(dobot.aconnect).return_annotation == "AsyncArm"
    assert list(inspect.signature(dobot.connect).parameters) == list(inspect.signature(dobot.aconnect).parameters)


def test_the_package_has_a_version_and_its_objects_say_what_they_are() -> None:
    assert dobot.__version__.split(".")[0].isdigit()
    with dobot.connect("virtual:firmware-1.1") as arm:
        assert repr(arm) == "<Arm virtual:firmware-1.1>"


ERRORS: list[Callable[[dobot.Arm], object]] = [
    lambda arm: arm.move_to(320, 0, 100),
    lambda arm: arm.world(),
    lambda arm: arm.run(dobot.program(steps=[{"wait": "look"}, {"go": {"x": 200, "y": 0, "z": 20}}]), progress=None),
]


@pytest.mark.parametrize("fails", ERRORS)
def test_exceptions_survive_pickling_and_copying(fails: Callable[[dobot.Arm], object]) -> None:
    with dobot.connect("virtual:") as arm, pytest.raises(dobot.Error) as raised:
        fails(arm)
    for again in (pickle.loads(pickle.dumps(raised.value)), copy.deepcopy(raised.value), copy.copy(raised.value)):
        assert type(again) is type(raised.value)
        assert str(again) == str(raised.value) and vars(again) == vars(raised.value)


def test_programs_and_reports_can_be_passed_to_other_processes_and_arms_cannot() -> None:
    program = dobot.program(title="there", steps=[{"go": {"x": 200, "y": 0, "z": 20}}])
    again = pickle.loads(pickle.dumps(program))
    assert (again.title, again.text, len(again)) == ("there", program.text, 1) and again.check() == program.check()
    with dobot.connect("virtual:", world="[pen]\ndown_z_mm = -40\n[paper]\nx_mm = [160, 280]\ny_mm = [-60, 60]\n") as arm:
        arm.run(again, progress=None)
        for value in (arm.next_status(), arm.pose, arm.joints, arm.state(), arm.check(program)):
            assert pickle.loads(pickle.dumps(value)) == value
        assert pickle.loads(pickle.dumps(arm.world())).ink == arm.ink
        with pytest.raises(TypeError, match="connect again in the other process"):
            pickle.dumps(arm)


WRONG: list[tuple[Callable[[dobot.Arm], object], str]] = [
    (lambda arm: arm.gripper(500), "gripper is 500; allowed is -90 to 90 .degrees."),
    (lambda arm: arm.move_to(200, 0, 20, pause=-1), "pause is -1; allowed is 0 to 655 .seconds."),
    (lambda arm: arm.move_to(math.nan, 0, 0), "x is NaN; allowed is a finite number"),
    (lambda arm: arm.move_joints(0, math.inf, 0), "rear is inf"),
    (lambda arm: arm.set_jog(servo_speed=0), "servo_speed is 0"),
    (lambda arm: arm.set_writing(acceleration=-1), "acceleration is -1"),
    (lambda arm: arm.vector(0, 1, 0, start_speed=-1), "start_speed is -1"),
    (lambda arm: arm.arm_laser(0), "seconds is 0"),
    (lambda arm: arm.follow([(200, 0, 20), (math.nan, 0, 0)]), r"points\[1\] is \(NaN, 0, 0\)"),
    (lambda arm: arm.follow([(200, 0, 20)], speed=0), "speed is 0; allowed are 1 to"),
]


@pytest.mark.parametrize("call, text", WRONG)
def test_a_refused_value_is_named_as_in_python(call: Callable[[dobot.Arm], object], text: str) -> None:
    with dobot.connect("virtual:") as arm:
        before = arm.next_status()
        with pytest.raises(dobot.Refused, match=text) as refused:
            call(arm)
        assert "Table" not in str(refused.value) and refused.value.kind
        assert arm.next_status() == before


def test_values_are_refused_in_the_same_words_by_a_station(station: str) -> None:
    with dobot.connect(station) as arm:
        arm.confirm_pose()
        with pytest.raises(dobot.Refused, match="x is NaN; allowed is a finite number"):
            arm.move_to(math.nan, 0, 0)


def test_a_file_in_place_of_a_plan_or_a_program_is_refused_with_the_call_to_use() -> None:
    with dobot.connect("virtual:") as arm:
        for call in (arm.run, arm.check):
            with pytest.raises(TypeError, match=r"`dobot_arm.program\('cubes.toml'\)`"):
                call("cubes.toml")  # type: ignore[arg-type]
        with pytest.raises(TypeError, match=r"`dobot_arm.plan\('harbour.svg'\)`"):
            arm.draw("harbour.svg")  # type: ignore[arg-type]
    with pytest.raises(ValueError, match=r"steps\[0\].go.z is nan; allowed is a finite number"):
        dobot.program(steps=[{"go": {"x": 200, "y": 0, "z": math.nan}}])
    with pytest.raises(ValueError, match="seed is -1"):
        dobot.connect("virtual:", seed=-1)


def test_numbers_and_arrays_of_numpy_are_allowed_everywhere() -> None:
    np = pytest.importorskip("numpy")
    x, y, z = np.array([210, 10, 20], dtype=np.float32)
    with dobot.connect("virtual:") as arm:
        arm.move_to(x, y, z, r=np.int64(0), suction=np.bool_(True))
        assert arm.pose[:3] == pytest.approx((210, 10, 20), abs=0.1)
        arm.follow(np.array([[210, 10, 20], [220, 0, 30]]), speed=np.float64(40))
        arm.run(dobot.program(steps=[{"go": {"x": x, "y": y, "z": z}, "pause": np.float32(0.1)}]), progress=None)
        assert arm.pose[:3] == pytest.approx((210, 10, 20), abs=0.1)
    plan = dobot.plan(text="I", height=np.float32(5), at=np.array([210, 20]))
    assert plan.strokes == dobot.plan(text="I", height=5, at=[210, 20]).strokes


def hint(call: Callable[[], object]) -> str:
    """The hint of a refused call."""
    with pytest.raises(dobot.Refused) as refused:
        call()
    assert refused.value.hint is not None and "/api/" not in refused.value.hint
    return refused.value.hint


def test_hints_name_the_calls_that_help(station: str) -> None:
    with dobot.connect(station, name="first") as arm, dobot.connect(station, name="second") as other:
        assert "`arm.state().policy`" in hint(lambda: arm.move_to(320, 0, 100))
        assert "`arm.arm_laser(60)`" in hint(lambda: arm.laser(True))
        arm.move_to(220, 0, 20)
        assert "`arm.request_control()`" in hint(lambda: other.move_to(220, 10, 20))
        arm.stop()
        assert "`arm.reset_stop()`" in hint(lambda: arm.move_to(220, 0, 20))
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(200, 80, 20)
        arm.set_faults("reset@1s")
        arm.wait(5)
        assert "`arm.confirm_pose()`" in hint(lambda: arm.move_to(220, 0, 20))


def test_files_and_lines_are_named_in_errors(tmp_path: Path) -> None:
    for read in (dobot.plan, dobot.program, dobot.log):
        with pytest.raises(FileNotFoundError) as missing:
            read(str(tmp_path / "none.toml"))
        assert missing.value.filename == str(tmp_path / "none.toml")
    with pytest.raises(ValueError, match=r"lines\[0\] is \(0, 0\); allowed is a line"):
        dobot.plan(lines=[(0, 0), (1, 1)])  # type: ignore[list-item]


def test_the_pose_is_the_last_known_one_and_unpacks() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        there = arm.move_to(220, 0, 20)
        x, y, z, r = arm.pose
        assert (x, y, z, r) == (there.x_mm, there.y_mm, there.z_mm, there.rotation_deg)
        base, rear, fore, servo = arm.joints
        assert (base, rear, fore, servo) == (there.base_deg, there.rear_deg, there.fore_deg, there.servo_deg)
        before = arm.state().at_s
        assert all(arm.pose == arm.pose for _ in range(100)) and arm.state().at_s == before
        assert arm.next_status().at_s > there.at_s


def test_statuses_are_received_from_the_call_on() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_to(220, -40, 20)
        statuses = arm.statuses()
        arm.move_to(220, 40, 20)
        seen = list(islice(statuses, 10))
        assert seen[0].y_mm < 0 and any(status.moving for status in seen)


def test_omitted_axes_relative_and_polar_moves() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_to(220, 10, 20)
        assert arm.move_to(z=30).z_mm == pytest.approx(30, abs=0.1)
        assert arm.pose[:2] == pytest.approx((220, 10), abs=0.1)
        arm.move_by(x=-20, y=5)
        assert arm.pose[:3] == pytest.approx((200, 15, 30), abs=0.1)
        turned = arm.move_by(r=10).rotation_deg
        assert arm.move_by(r=-10).rotation_deg == pytest.approx(turned - 10, abs=0.1)
        arm.move_polar(reach=210, angle=30)
        assert arm.pose[:3] == pytest.approx((210 * math.cos(math.pi / 6), 105, 30), abs=0.1)
        assert arm.joints.base_deg == pytest.approx(30, abs=0.1)
        assert arm.move_joints(servo=20).servo_deg == pytest.approx(20, abs=0.1)


def test_a_move_to_where_the_arm_is_switches_the_tool() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        there = arm.move_to(220, 0, 20)
        again = arm.move_to(220, 0, 20, suction=True)
        assert again.suction and (again.x_mm, again.z_mm) == pytest.approx((there.x_mm, there.z_mm), abs=0.1)


def test_a_move_is_straight_and_a_jump_lifts() -> None:
    with dobot.connect("virtual:") as arm:
        arm.move_to(220, -40, 20)
        with arm.record() as straight:
            arm.move_to(220, 40, 20)
        assert max(status.z_mm for status in straight.statuses) < 21
        assert max(status.x_mm for status in straight.statuses) < 221
        with arm.record() as lifted:
            arm.jump(220, -40, 20)
        assert max(status.z_mm for status in lifted.statuses) > 35


def test_the_state_of_a_station_is_known(station: str) -> None:
    with dobot.connect(station, name="first") as arm:
        free = arm.state()
        assert free.control is None and free.stop is None and free.locked is None and free.jobs == ()
        assert free.link.phase == "up" and free.policy["workspace"]["reach_mm"] == [129, 321]
        arm.confirm_pose()
        assert arm.state().trusted
        arm.move_to(220, 0, -20)
        arm.draw(dobot.plan(text="I", height=5), progress=None)
        [job] = arm.state().jobs
        assert (job.kind, job.phase, job.title) == ("drawing", "done", "I")
        arm.arm_laser(30)
        assert 0 < arm.state().laser.armed_for_s <= 30
        arm.stop("lunch")
        stopped = arm.state().stop
        assert stopped is not None and (stopped.by, stopped.reason) == ("first", "lunch")
        arm.reset_stop()
        assert arm.state().stop is None


def test_control_is_requested_granted_and_released(station: str) -> None:
    async def main() -> None:
        async with (
            await dobot.aconnect(station, name="first") as first,
            await dobot.aconnect(station, name="second") as second,
        ):
            await first.confirm_pose()
            await first.move_to(220, 0, 20)
            control = (await second.state()).control
            assert control is not None and (control.name, control.mine) == ("first", False)
            with pytest.raises(dobot.Refused) as refused:
                await second.request_control(wait=0)
            assert refused.value.kind == "no-lease"
            waits = asyncio.create_task(second.request_control(wait=60))
            requests: dict[int, str] = {}
            while not requests:
                await first.next_status()
                holder = (await first.state()).control
                assert holder is not None
                requests = holder.requests
            [(client, name)] = requests.items()
            assert name == "second"
            await first.grant_control(client)
            await waits
            await second.move_to(220, 10, 20)
            await second.release_control()
            assert (await first.state()).control is None
            await first.request_control()
            taken = (await first.state()).control
            assert taken is not None and taken.mine

    asyncio.run(main())


def test_an_asynchronous_arm_has_a_pose_after_its_first_status() -> None:
    async def main() -> None:
        async with await dobot.aconnect("virtual:") as arm:
            with pytest.raises(dobot.Failed, match="no status has arrived yet"):
                arm.pose
            await arm.move_to(220, 0, 20)
            assert arm.pose.x_mm == pytest.approx(220, abs=0.5)
        with pytest.raises(dobot.Closed):
            arm.pose

    asyncio.run(main())
