"""The examples of docs/python.md."""

from __future__ import annotations

import re
import shutil
from pathlib import Path

import pytest

import dobot_arm as dobot

ROOT = Path(__file__).parents[2]
BLOCKS = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "python.md").read_text(), re.DOTALL)


def test_the_examples_of_the_documentation_run_one_after_the_other(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    shutil.copy(ROOT / "examples" / "drawings" / "harbour.svg", tmp_path)
    (tmp_path / "square.script").write_text("!end 4000\ncredit 3 0 240 0 0 0 0 2 0 0\n")
    assert len(BLOCKS) > 8
    with dobot.connect("virtual:firmware-1.1") as arm:
        arm.move_to(220, 0, 20)
        names: dict[str, object] = {"dobot": dobot, "answer": lambda question: question.answers[0]}
        for block in BLOCKS:
            # Other tests read and export recordings.
            names["arm"] = arm
            exec(block.partition("log = dobot.log")[0], names)
        assert arm.state().stop is None and dobot.program("cubes.toml").check().problems == ()
