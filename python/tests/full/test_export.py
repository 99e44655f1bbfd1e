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
