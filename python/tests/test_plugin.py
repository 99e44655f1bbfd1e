"""The pytest plugin."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import dobot_arm as dobot

LOOK = "\n    assert not virtual_arm.next_status().suction\n"


def test_an_hour_of_an_arm_takes_no_hour(virtual_arm: dobot.Arm) -> None:
    virtual_arm.move_to(220, 0, 20)
    virtual_arm.wait(3600)
    virtual_arm.move_to(220, 60, 20)
    assert virtual_arm.pose.y_mm == pytest.approx(60, abs=0.1)


@pytest.mark.dobot(personality="firmware-1.1")
def test_the_rules_hold_in_a_test_too(virtual_arm: dobot.Arm) -> None:
    with pytest.raises(dobot.Refused, match="table"):
        virtual_arm.move_to(200, 0, -90)


def tried(folder: Path, test: str, *words: str) -> str:
    """The output of pytest for a test in a separate process."""
    (folder / "test_it.py").write_text(test)
    # The plugin is part of the package.
    run = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "--strict-markers", str(folder), *words]
    return subprocess.run(run, capture_output=True, text=True, cwd=folder, check=False).stdout


def test_an_unknown_personality_is_an_error(tmp_path: Path) -> None:
    reported = tried(tmp_path, f"def test_it(virtual_arm):{LOOK}", "--dobot-personality", "robot")
    assert "firmware-1.1" in reported and "1 error" in reported, reported


def test_a_marker_with_an_unknown_option_is_an_error(tmp_path: Path) -> None:
    test = f"import pytest\n@pytest.mark.dobot('firmware-1.1')\ndef test_it(virtual_arm):{LOOK}"
    assert 'dobot(personality="firmware-1.1", world=' in tried(tmp_path, test)


def test_each_test_has_an_arm_of_its_own(tmp_path: Path) -> None:
    test = f"def test_one(virtual_arm):\n    virtual_arm.suction(True)\ndef test_two(virtual_arm):{LOOK}"
    assert "2 passed" in tried(tmp_path, test)
