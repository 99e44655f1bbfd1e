"""Hands in front of a camera, with the cases of the page: tests/hands/cases.json."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import dobot_arm as dobot
from dobot_arm.hand import Hand, Meaning, Picture, SeenHand
from dobot_arm.hands import Follower

DATA = json.loads((Path(__file__).parents[2] / "tests/hands/cases.json").read_text())
ASPECT = 4 / 3
OPEN: dict[str, Any] = {"pose": "open"}


def seen(case: dict[str, Any], n: int = 0) -> SeenHand:
    """A hand of a case in its nth picture."""
    score = case.get("score", 0.95)
    if "recorded" in case:
        return SeenHand(score, DATA["recorded"][case["recorded"]]["points"])
    (x0, y0), palm = case.get("at", (0.5, 0.7)), case.get("size", 0.2) + case.get("grows", 0) * n
    return SeenHand(score, [(x0 + x * palm, y0 - y * palm * ASPECT) for x, y in DATA["poses"][case["pose"]]])


def pictures(steps: list[dict[str, Any]], period_ms: float = 50) -> Iterator[Picture]:
    """The pictures of steps."""
    hands = ([seen(hand, n) for hand in step["hands"]] for step in steps for n in range(step["times"]))
    return (Picture(period_ms * n, shown, ASPECT) for n, shown in enumerate(hands))


@pytest.mark.parametrize("case", DATA["cases"], ids=lambda case: str(case["title"]))
def test_a_hand_means_what_it_means_on_the_page(case: dict[str, Any]) -> None:
    hand = Hand()
    meanings = iter([hand.look(picture) for picture in pictures(case["steps"])])
    for step in case["steps"]:
        shown = [next(meanings) for _ in range(step["times"])]
        assert {meaning.state for meaning in shown} == {step["state"]}
        assert {meaning.movement is not None for meaning in shown} == {step["state"] == "controls"}
        movement = shown[-1].movement
        if "closed" in step:
            assert movement is not None and movement.closed == step["closed"]
        if "movement" in step:
            assert movement is not None and vars(movement) == pytest.approx(step["movement"], abs=0.01)


def test_a_point_that_is_no_number_sends_nothing_and_an_open_hand_has_to_be_held_again() -> None:
    hand = Hand()
    states = [hand.look(picture).state for picture in pictures([{"times": 11, "hands": [OPEN]}])]
    assert states[-1] == "controls"
    broken = SeenHand(0.95, [(float("nan"), 0.0)] * 21)
    assert [hand.look(Picture(550 + 50 * n, [broken], ASPECT)) for n in range(8)] == [Meaning("unsure")] * 8
    assert hand.look(Picture(950, [seen(OPEN)], ASPECT)) == Meaning("opening")


@pytest.fixture(params=["specification", "firmware-1.1"])
def arm(request: pytest.FixtureRequest) -> Iterator[dobot.Arm]:
    with dobot.connect(f"virtual:{request.param}") as arm:
        arm.move_to(220, 0, 40)
        yield arm


def follow(arm: dobot.Arm, steps: list[dict[str, Any]], period_ms: float = 50) -> dobot.Pose:
    """Follows a hand whose every position the arm reaches before the next picture."""
    follower = Follower(arm, arm)
    for picture in pictures(steps, period_ms):
        follower.look(picture)
        follower.wait()
    follower.finish()
    return pose(arm)


def pose(arm: dobot.Arm) -> dobot.Pose:
    """Where the arm is now."""
    arm.next_status()
    return arm.pose


TAKES_CONTROL = {"times": 11, "hands": [OPEN]}


def test_the_arm_goes_where_the_hand_goes_and_closes_with_a_pinch(arm: dobot.Arm) -> None:
    moved = {"times": 20, "hands": [{"pose": "open", "at": [0.55, 0.65]}]}
    reached = follow(arm, [TAKES_CONTROL, moved])
    if "specification" in repr(arm):
        assert reached[:3] == pytest.approx((220, 15, 51.25), abs=0.5)
    # An arm as sold approaches the hand step by step, from above (note N18).
    assert reached[:2] == pytest.approx((220, 15), abs=1)
    assert not arm.next_status().suction
    follow(arm, [TAKES_CONTROL, {"times": 4, "hands": [{"pose": "pinch"}]}])
    assert arm.next_status().suction


@pytest.mark.parametrize(
    "hands", [[], [OPEN, {"pose": "open", "at": [0.2, 0.7]}], [{"pose": "open", "at": [0.6, 0.6], "score": 0.6}]]
)
def test_without_one_clear_hand_nothing_more_is_sent(arm: dobot.Arm, hands: list[dict[str, Any]]) -> None:
    reached = follow(arm, [TAKES_CONTROL])
    follower = Follower(arm, arm)
    for picture in pictures([TAKES_CONTROL, {"times": 40, "hands": hands}]):
        follower.look(picture)
        follower.wait()
    follower.finish()
    assert pose(arm) == pytest.approx(reached, abs=0.5)
    assert arm.state().control is None


def test_a_hand_at_rest_keeps_control(arm: dobot.Arm, capsys: pytest.CaptureFixture[str]) -> None:
    follow(arm, [TAKES_CONTROL, {"times": 60, "hands": [{"pose": "open", "at": [0.52, 0.7]}]}])
    assert capsys.readouterr().out.splitlines() == ["hold it", "the arm follows your hand"]


def test_at_most_ten_positions_are_sent_per_second(arm: dobot.Arm, monkeypatch: pytest.MonkeyPatch) -> None:
    shown_ms, sent_ms = [0.0], [-1000.0]
    follower = Follower(arm, arm)
    monkeypatch.setattr(dobot.Arm, "hand", lambda *_, **__: sent_ms.append(shown_ms[-1]))
    # A position of its own in each picture, 100 pictures per second.
    moves = [{"times": 1, "hands": [{"pose": "open", "at": [0.5 + 0.001 * n, 0.7]}]} for n in range(100)]
    for picture in pictures([{"times": 51, "hands": [OPEN]}, *moves], 10):
        shown_ms.append(picture.at_ms)
        follower.look(picture)
        follower.wait()
    follower.finish()
    assert sent_ms[1:] == [500 + 100 * n for n in range(11)]


def test_a_flat_hand_pushed_forward_stops_the_arm(arm: dobot.Arm, capsys: pytest.CaptureFixture[str]) -> None:
    follow(arm, [TAKES_CONTROL, {"times": 7, "hands": [{"pose": "open", "grows": 0.015}]}])
    stop = arm.state().stop
    assert stop is not None and stop.reason == "a flat hand was pushed forward"
    # A hand does not clear the stop, and is refused.
    before = pose(arm)
    follow(arm, [TAKES_CONTROL, {"times": 20, "hands": [{"pose": "open", "at": [0.6, 0.7]}]}])
    assert arm.state().stop is not None and pose(arm) == before
    assert "stop" in capsys.readouterr().out


def test_a_position_that_is_refused_is_reported_and_the_hand_has_to_be_opened_again(
    arm: dobot.Arm, capsys: pytest.CaptureFixture[str]
) -> None:
    arm.move_to(290, 0, 40)
    raised = [{"times": 2, "hands": [{"pose": "open", "at": [0.5, 0.7 - 0.05 * n]}]} for n in range(12)]
    follow(arm, [TAKES_CONTROL, *raised])
    said = capsys.readouterr().out.splitlines()
    assert said[:2] == ["hold it", "the arm follows your hand"]
    assert "the arm allows" in said[2] and said[-1] == "hold it" and len(said) <= 5, said
    assert pose(arm).z_mm < 180


def test_the_station_marks_what_comes_from_a_hand(station: str) -> None:
    with dobot.connect(station) as shown, dobot.connect(station) as arm:
        shown.confirm_pose()
        y_mm = pose(shown).y_mm
        follower = Follower(arm, shown)
        for picture in pictures([TAKES_CONTROL, {"times": 20, "hands": [{"pose": "open", "at": [0.53, 0.7]}]}]):
            follower.look(picture)
            follower.wait()
        follower.finish()
        assert pose(shown).y_mm == pytest.approx(y_mm + 9, abs=0.5)
    assert "hand: " in notices(station)


def notices(station: str) -> str:
    """The notices of a station, as text."""
    from urllib.request import urlopen

    with urlopen(f"{station}/api/v1/notices") as answer:
        return str(answer.read())


def test_without_mediapipe_or_with_a_wrong_video_the_program_says_what_to_do(tmp_path: Path) -> None:
    wrong = tmp_path / "notes.txt"
    wrong.write_text("no video")
    command = [sys.executable, "-m", "dobot_arm.hands", "--to", "virtual:", "--video", str(wrong)]
    done = subprocess.run(command, capture_output=True, text=True, timeout=120)
    assert done.returncode == 1
    assert "pip install dobot-arm[hands]" in done.stderr or f"{wrong} is no video" in done.stderr, done.stderr
