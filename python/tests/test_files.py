"""Files that a station stores."""

from __future__ import annotations

from pathlib import Path

import pytest

import dobot_arm as dobot

SVG = b'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1H8" stroke="red"/></svg>'


def test_a_file_is_stored_listed_read_and_deleted(station: str, tmp_path: Path) -> None:
    files = dobot.files(station)
    path = tmp_path / "line.svg"
    path.write_bytes(SVG)
    stored = files.put(path)
    assert (stored.name, stored.kind, stored.size) == ("line.svg", "drawing", len(SVG))
    assert [file.number for file in files.list()] == [stored.number]
    assert files.get("line.svg") == files.get(stored) == files.get(stored.number) == SVG
    files.rm("line.svg")
    assert files.list() == []
    with pytest.raises(FileNotFoundError):
        files.get("line.svg")


def test_a_taken_name_is_refused_unless_the_caller_decides(station: str) -> None:
    files = dobot.files(station)
    files.put("a.svg", SVG)
    with pytest.raises(dobot.Refused) as refused:
        files.put("a.svg", b"other")
    assert refused.value.kind == "file-exists"
    assert files.put("a.svg", b"other", existing="keep_both").name == "a (2).svg"
    assert files.put("a.svg", b"other", existing="replace").revision == 2


def test_a_name_that_is_a_path_is_refused(station: str) -> None:
    with pytest.raises(dobot.Refused) as refused:
        dobot.files(station).put("../tokens.toml", b"x")
    assert refused.value.kind == "file-name"


def test_an_arm_without_a_station_has_no_files() -> None:
    with pytest.raises(ValueError, match="station"):
        dobot.files("virtual:")
