"""Programs from Python."""

from __future__ import annotations

import asyncio
import json
import typing
from pathlib import Path

import pytest

import dobot_arm as dobot
from dobot_arm._core import Taught

EXAMPLES = Path(__file__).parents[2] / "examples" / "programs"

TO_AND_FRO: list[dobot.Step] = [
    {"go": "here", "suction": True, "pause": 0.5},
    {"go": "there", "path": "movl", "suction": False},
]
POINTS = {"here": {"x": 200, "y": 60, "z": 0}, "there": {"x": 200, "y": -60, "z": 0}}


def test_a_program_made_of_steps_is_done_step_by_step() -> None:
    program = dobot.program(title="to and fro", points=POINTS, steps=TO_AND_FRO)
    reported: list[tuple[int, int]] = []
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.run(program, progress=lambda step, steps, cycle, cycles: reported.append((step, steps)))
        end = arm.next_status()
        assert (end.x_mm, end.y_mm, end.z_mm) == pytest.approx((200, -60, 0), abs=0.5)
        assert not end.suction
    assert reported == sorted(reported) and {step for step, _ in reported} == {1, 2}
    assert {steps for _, steps in reported} == {2}


def test_a_program_is_done_as_often_as_asked() -> None:
    program = dobot.program(points=POINTS, steps=TO_AND_FRO)
    with dobot.connect("virtual:firmware-1.1") as arm:
        reported: list[tuple[int, int | None]] = []
        arm.run(program, times=3, progress=lambda step, steps, cycle, cycles: reported.append((cycle, cycles)))
        assert {cycle for cycle, _ in reported} >= {1, 2, 3} and {cycles for _, cycles in reported} == {3}
        arm.move_to(220, 0, 20)
        arm.run(program, from_step=2)
        assert arm.next_status().y_mm == pytest.approx(-60, abs=0.5)
        for wrong in (0, 3):
            with pytest.raises(dobot.Refused, match="allowed are 1 to 2"):
                arm.run(program, from_step=wrong)
        for never in (0, -1, "sometimes"):
            with pytest.raises(ValueError, match="forever"):
                arm.run(program, times=never)  # type: ignore[arg-type]


def test_a_program_for_ever_is_ended_by_its_progress() -> None:
    program = dobot.program(points=POINTS, steps=[{"repeat": "forever", "steps": TO_AND_FRO}])
    assert program.check().total_s is None

    def enough(step: int, steps: int, cycle: int, cycles: int | None) -> None:
        assert cycles is None
        if cycle == 3:
            raise RuntimeError("enough")

    with dobot.connect("virtual:firmware-1.1") as arm:
        with pytest.raises(RuntimeError, match="enough"):
            arm.run(program, progress=enough)


def test_a_check_reports_the_steps_of_a_program_and_their_durations() -> None:
    report = dobot.program(points=POINTS, steps=TO_AND_FRO).check(dialect="firmware-1.1")
    assert [step.label for step in report.steps] == ["go to here", "go to there"]
    assert not report.problems
    assert report.once_s is not None
    # The steps without the waits for a status.
    assert report.once_s == pytest.approx(sum(step.takes_s for step in report.steps), abs=1) and report.once_s > 1
    assert report.total_s == report.once_s and report.cycle_s is None


def test_all_problems_are_reported_before_anything_moves() -> None:
    far: dobot.Step = {"go": {"x": 450, "y": 0, "z": 0}}
    program = dobot.program(points=POINTS, steps=[*TO_AND_FRO, far, far])
    assert [problem.step for problem in program.check().problems] == [3, 4]
    with dobot.connect("virtual:") as arm:
        before = arm.next_status()
        assert len(arm.check(program).problems) == 2
        with pytest.raises(dobot.Refused) as refused:
            arm.run(program)
        assert refused.value.kind == "bad-program"
        assert "step 3" in str(refused.value) and "step 4" in str(refused.value)
        assert arm.next_status() == before


def test_an_invalid_program_is_an_error_with_its_step_or_line(tmp_path: Path) -> None:
    with pytest.raises(ValueError, match='step 2: there is no point "somewhere"'):
        dobot.program(points=POINTS, steps=[TO_AND_FRO[0], {"go": "somewhere"}])
    with pytest.raises(ValueError, match="line 2"):
        dobot.program(text="[[steps]]\nfly = true")
    wrong = tmp_path / "wrong.toml"
    wrong.write_text("[[steps]]\nfly = true")
    with pytest.raises(ValueError, match="wrong.toml.*line 2"):
        dobot.program(wrong)
    with pytest.raises(ValueError, match=r"\.toml, \.xml, \.play or \.playback"):
        dobot.program("cubes.txt")
    with pytest.raises(FileNotFoundError):
        dobot.program("no-such-file.toml")
    with pytest.raises(TypeError, match="steps="):
        dobot.program()
    with pytest.raises(ValueError):
        dobot.program(steps=[{"go": {"x": float("nan"), "y": 0, "z": 0}}])


@pytest.mark.parametrize("name", ["pick-and-place.toml", "stack.toml", "sort-by-colour.toml"])
def test_the_examples_are_read_and_can_be_done(name: str) -> None:
    program = dobot.program(EXAMPLES / name)
    assert program.text == (EXAMPLES / name).read_text()
    assert not program.check().problems


def test_a_program_is_saved_and_read_again(tmp_path: Path) -> None:
    program = dobot.program(title="to and fro", points=POINTS, steps=TO_AND_FRO)
    file = tmp_path / "to-and-fro.toml"
    assert program.save(file) == []
    again = dobot.program(file)
    assert (again.title, again.text, len(again)) == ("to and fro", program.text, 2)


def test_the_vendors_points_are_read_and_written(tmp_path: Path) -> None:
    joints: list[dobot.Step] = [
        {"go": {"base": 10, "rear": 40, "fore": 40}, "path": "movj"},
        {"go": {"base": -10, "rear": 40, "fore": 40}, "path": "movj"},
    ]
    file = tmp_path / "PlayBackPoints.xml"
    assert dobot.program(steps=joints).save(file) == []
    read = dobot.program(file)
    assert len(read) == 2
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.run(read)
        assert arm.joints.base_deg == pytest.approx(-10, abs=0.1)
    there = tmp_path / "three.play"
    assert dobot.program(steps=[*joints, {"go": {"x": 200, "y": 20, "z": 30}}]).save(there) == []
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.run(dobot.program(there))
        status = arm.next_status()
        assert (status.x_mm, status.y_mm, status.z_mm) == pytest.approx((200, 20, 30), abs=0.1)
    with pytest.raises(ValueError, match="step 1 .*too far"):
        dobot.program(steps=[{"go": {"x": 400, "y": 0, "z": 0}}]).save(there)


def test_a_program_that_waits_for_a_person_says_so_and_continues() -> None:
    program = dobot.program(
        points=POINTS,
        steps=[TO_AND_FRO[0], {"wait": "put the cube there"}, TO_AND_FRO[1]],
    )
    with dobot.connect("virtual:firmware-1.1") as arm:
        with pytest.raises(dobot.Paused, match="put the cube there") as paused:
            arm.run(program)
        assert paused.value.job > 0
        assert arm.next_status().y_mm == pytest.approx(60, abs=0.5)
        with pytest.raises(dobot.Refused, match="waits for a person"):
            arm.resume()
        assert arm.next_status().y_mm == pytest.approx(60, abs=0.5)
        arm.resume(as_person=True)
        assert arm.next_status().y_mm == pytest.approx(-60, abs=0.5)
        with pytest.raises(dobot.Failed, match="no paused job"):
            arm.resume()
        with pytest.raises(dobot.Paused):
            arm.run(program)
        arm.cancel()
        with pytest.raises(dobot.Failed, match="no paused job"):
            arm.cancel()
        arm.move_to(220, 0, 20)


def test_a_program_runs_at_a_station_waits_there_and_goes_on(station: str) -> None:
    program = dobot.program(
        points={"here": {"x": 200, "y": 15, "z": 30}, "there": {"x": 200, "y": -15, "z": 30}},
        steps=[{"go": "here", "path": "movl"}, {"wait": "put the cube there"}, {"go": "there", "path": "movl"}],
    )
    with dobot.connect(station) as arm:
        arm.confirm_pose()
        assert arm.check(program).problems == ()
        arm.move_to(200, 0, 30)
        with pytest.raises(dobot.Paused, match="put the cube there"):
            arm.run(program)
        assert arm.next_status().y_mm == pytest.approx(15, abs=0.5)
        arm.resume(as_person=True)
        assert arm.next_status().y_mm == pytest.approx(-15, abs=0.5)


def test_coroutines_run_programs_too() -> None:
    async def main() -> None:
        async with await dobot.aconnect("virtual:firmware-1.1") as arm:
            program = dobot.program(points=POINTS, steps=TO_AND_FRO)
            assert (await arm.check(program)).problems == ()
            await arm.run(program)
            assert (await arm.next_status()).y_mm == pytest.approx(-60, abs=0.5)

    asyncio.run(main())


SORT = """
[[steps]]
go = { x = 220, y = 0, z = 40 }
[[steps]]
go = { from = "cube" }
[[steps]]
choose = "Which side?"
by = "seen"
[[steps.when]]
answer = "left"
[[steps.when.steps]]
go = { x = 200, y = 80, z = 40 }
[[steps.when]]
answer = "right"
"""


def seen(question: dobot.Question) -> str | tuple[float, ...]:
    if question.place == "cube":
        return (200.0, -40.0, 20.0)
    assert question.text == "Which side?" and question.answers == ("left", "right")
    return "left"


def test_a_function_answers_the_questions_of_a_program() -> None:
    with dobot.connect("virtual:") as arm:
        program = dobot.program(text=SORT)
        assert arm.check(program).depends_on_answers
        asked: list[str] = []

        def answer(question: dobot.Question) -> str | tuple[float, ...]:
            asked.append(question.text)
            return seen(question)

        arm.run(program, progress=None, ask=answer)
        assert asked == ["Where is cube?", "Which side?"]
        assert abs(arm.next_status().y_mm - 80) < 0.5


def test_a_coroutine_runs_a_program_that_asks() -> None:
    async def main() -> None:
        async with await dobot.aconnect("virtual:") as arm:
            await arm.run(dobot.program(text=SORT), progress=None, ask=seen)
            assert abs((await arm.next_status()).y_mm - 80) < 0.5

    asyncio.run(main())


def test_a_question_that_nobody_answers_or_a_wrong_answer_is_an_error() -> None:
    with dobot.connect("virtual:") as arm:
        with pytest.raises(dobot.Failed, match="give `run` a function `ask`"):
            arm.run(dobot.program(text=SORT), progress=None)
    with dobot.connect("virtual:") as arm:
        with pytest.raises(dobot.Refused, match="the program asks for the position"):
            arm.run(dobot.program(text=SORT), progress=None, ask=lambda question: "left")


def test_the_words_of_a_step_are_those_of_the_schema() -> None:
    schema = json.loads(Taught.schema())["$defs"]
    assert set(dobot.Step.__annotations__) == set(schema["Step"]["properties"])
    assert set(dobot.Point.__annotations__) == set(schema["Point"]["properties"])
    for key, name in [("path", "MovingMode"), ("by", "AnsweredBy")]:
        values = typing.get_args(typing.get_type_hints(dobot.Step)[key])
        assert set(values) == {choice["const"] for choice in schema[name]["oneOf"]}, key
    description = dobot.program.__doc__ or ""
    for key in json.loads(Taught.schema())["properties"]:
        assert f"``{key}``" in description, key


def test_every_kind_of_refusal_has_a_name_a_meaning_and_a_place_in_the_documentation() -> None:
    kinds = dobot.kinds()
    assert set(typing.get_args(dobot.Kind)) == set(kinds)
    page = (Path(__file__).parents[2] / "docs" / "python.md").read_text()
    for kind, meaning in kinds.items():
        assert meaning.endswith("."), kind
        refused = dobot.Refused("what was found", hint="what helps", kind=kind)
        assert isinstance(refused, dobot.Error) and refused.kind == kind and "what helps" in str(refused)
        assert f"`{kind}`" in page, kind


def test_refusals_come_with_their_kind() -> None:
    with dobot.connect("virtual:firmware-1.1") as arm:
        with pytest.raises(dobot.Refused) as refused:
            arm.move_to(200, 0, -90)
        assert refused.value.kind == "policy" and refused.value.rule == "table"
        assert refused.value.at_mm is not None
        with pytest.raises(dobot.Refused) as refused:
            arm.gripper(200)
        assert refused.value.kind == "command"
        arm.stop()
        with pytest.raises(dobot.Refused) as refused:
            arm.move_to(220, 0, 20)
        assert refused.value.kind == "stopped"
