"""Shared fixtures."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

import dobot_arm as dobot


@pytest.fixture
def station(tmp_path: Path) -> Iterator[str]:
    """The address of a station with a virtual arm, run by the program in ``DOBOT``."""
    program = os.environ.get("DOBOT")
    if program is None:
        pytest.skip("the environment variable DOBOT is not set to a `dobot` program")
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
            assert any("the arm is connected" in line for line in lines)
            yield address
        finally:
            process.terminate()


@pytest.fixture
def recording(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """The recording of a rest, and a move from (200, 0, 60) to (220, 40, 20)."""
    program = os.environ.get("DOBOT")
    if program is None:
        pytest.skip("the environment variable DOBOT is not set to a `dobot` program")
    monkeypatch.setenv("DOBOT_DATA", str(tmp_path / "data"))
    monkeypatch.setenv("PATH", str(Path(program).parent))
    with dobot.serve("specification", speed=20) as served:
        with dobot.connect(served.tcp, dialect="specification") as arm:
            arm.confirm_pose()
            # Longer than the rest that a trimmed episode keeps.
            arm.wait(0.8)
            arm.move_to(200, 0, 60)
            arm.move_to(220, 40, 20)
    [file] = (tmp_path / "data" / "recordings").glob("*.mcap")
    yield file
