"""Simulations and recordings as tables."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest

import dobot_arm as dobot

np = pytest.importorskip("numpy")

SCRIPT = "!end 4000\ncredit 3 0 240 0 0 0 0 2 0 0\n"


def test_a_script_is_run_and_its_trace_is_arrays() -> None:
    run = dobot.simulate(text=SCRIPT, personality="firmware-1.1")
    assert run.end_s == pytest.approx(4.0) and run.refused == [] and run.unsent == 0
    statuses = run.statuses
    assert list(statuses)[:4] == ["at_s", "x_mm", "y_mm", "z_mm"]
    # A status every 80 ms.
    assert np.allclose(np.diff(statuses["at_s"]), 0.08)
    assert statuses["x_mm"][-1] == pytest.approx(240, abs=0.1)
    assert statuses["suction"].dtype == bool and not statuses["suction"].any()
    ticks = run.ticks
    # A control tick every 20 ms.
    assert np.allclose(np.diff(ticks["at_s"]), 0.02)
    assert ticks["x_mm"][-1] == pytest.approx(240, abs=0.1)
    assert ticks["rear_pulses"].dtype == np.int64
    assert run._repr_svg_().startswith("<svg")


def test_a_table_becomes_a_frame_of_pandas() -> None:
    pandas = pytest.importorskip("pandas")
    statuses = dobot.simulate(text=SCRIPT).statuses
    frame = statuses.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert list(frame.columns) == list(statuses) and len(frame) == statuses.rows > 10


def test_refused_commands_are_reported_with_their_time() -> None:
    # Moving mode 7 does not exist.
    run = dobot.simulate(text="!end 2000\n100 3 0 240 0 0 0 0 7 0 0\n")
    [(at_s, why)] = run.refused
    assert 0.1 < at_s < 0.3 and "7" in why


def test_an_invalid_script_is_an_error_with_its_line(tmp_path: Path) -> None:
    file = tmp_path / "wrong.script"
    file.write_text("!end 100\nfly\n")
    with pytest.raises(ValueError, match="wrong.script:2"):
        dobot.simulate(file)
    with pytest.raises(FileNotFoundError):
        dobot.simulate("none.script")
    with pytest.raises(ValueError, match="firmware-1.1"):
        dobot.simulate(text=SCRIPT, personality="robot")
    with pytest.raises(TypeError, match="text="):
        dobot.simulate()


def test_a_recording_is_read_as_tables(recording: Path) -> None:
    log = dobot.log(recording)
    assert log.damage is None
    statuses, commands = log.statuses, log.commands
    last = [float(statuses[name][-1]) for name in ("x_mm", "y_mm", "z_mm")]
    assert last == pytest.approx([220, 40, 20], abs=0.5)
    assert (np.diff(statuses["at_s"]) >= 0).all()
    assert statuses["time"].dtype == "datetime64[ns]"
    assert list(commands["command"]).count("move_to") == 2
    half = float(statuses["at_s"][-1]) / 2
    first = dobot.log(recording, end=half).statuses
    assert 0 < first.rows < statuses.rows and first["at_s"][-1] <= half


def test_a_recording_is_exported(recording: Path, tmp_path: Path) -> None:
    log = dobot.log(recording)
    out = tmp_path / "run.csv"
    assert log.export(out) == [str(out), str(tmp_path / "run.commands.csv")]
    assert len(out.read_text().splitlines()) == log.statuses.rows + 1
    with pytest.raises(FileExistsError, match="overwrite"):
        log.export(out)
    log.export(out, overwrite=True)
    with pytest.raises(ValueError, match=r"\.parquet"):
        log.export(tmp_path / "run.xlsx")
    with pytest.raises(ValueError, match="no packet"):
        dobot.log(recording, start=1e6).export(tmp_path / "none.csv")


def test_a_file_that_is_not_a_recording_is_an_error(tmp_path: Path) -> None:
    with pytest.raises(FileNotFoundError):
        dobot.log("none.mcap")
    wrong = tmp_path / "wrong.mcap"
    wrong.write_text("no recording")
    with pytest.raises(ValueError, match="wrong.mcap"):
        dobot.log(wrong)
    with pytest.raises(ValueError, match="seconds"):
        dobot.log("none.mcap", start=-1)


def test_numpy_and_pandas_are_loaded_only_when_asked_for() -> None:
    look = (
        "import sys, dobot_arm as dobot; run = dobot.simulate(text='!end 100'); run.statuses;"
        "print([name for name in ('numpy', 'pandas', 'asyncio') if name in sys.modules])"
    )
    reported = subprocess.run([sys.executable, "-c", look], capture_output=True, text=True, check=True)
    assert reported.stdout.strip() == "[]"
