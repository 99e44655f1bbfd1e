"""What several tests need."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest


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
