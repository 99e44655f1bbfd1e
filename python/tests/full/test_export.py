"""Exports that need Parquet."""

from __future__ import annotations

from pathlib import Path

import pytest

import dobot_arm as dobot


def test_a_recording_is_exported_as_parquet_and_as_a_dataset(recording: Path, tmp_path: Path) -> None:
    log = dobot.log(recording)
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    log.export(tmp_path / "run.parquet")
    frame = pandas.read_parquet(tmp_path / "run.parquet")
    assert list(frame["x_mm"]) == list(log.statuses["x_mm"])
    [dataset] = log.export(tmp_path / "dataset", task="Go there.")
    assert (Path(dataset) / "meta" / "info.json").exists()


def test_parts_of_a_recording_are_the_episodes_of_one_dataset(recording: Path, tmp_path: Path) -> None:
    pandas = pytest.importorskip("pandas")
    pytest.importorskip("pyarrow")
    whole = dobot.log(recording)
    half = float(whole.statuses["at_s"][-1]) / 2
    parts = [dobot.log(recording, end=half), dobot.log(recording, start=half)]
    episodes, frames = dobot.dataset(tmp_path / "two", parts, task="Go there.")
    assert episodes == 2
    data = pandas.read_parquet(tmp_path / "two" / "data" / "chunk-000" / "file-000.parquet")
    assert len(data) == frames and set(data["episode_index"]) == {0, 1}
    _, fewer = dobot.dataset(tmp_path / "trimmed", [whole], task="Go there.", trim_idle=True)
    assert 0 < fewer < frames
