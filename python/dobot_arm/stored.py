"""The files that a station stores: drawings, photos and programs."""

from __future__ import annotations

import json
import os
from base64 import b64encode
from dataclasses import dataclass
from pathlib import Path as FilePath
from typing import Any, Literal

from . import _core

Existing = Literal["refuse", "replace", "keep_both"]
"""What to do if a file of the same name has other content."""


@dataclass(frozen=True)
class StoredFile:
    """A stored file."""

    number: int
    """Its number."""
    name: str
    """Its name."""
    kind: Literal["drawing", "photo", "program"]
    """What it is."""
    revision: int
    """Its revision, from 1: each change by a person is another one."""
    size: int
    """The size of its content, in bytes."""
    options: dict[str, Any] | None
    """The last placement, pen and other options of its drawing."""
    last_job: dict[str, Any] | None
    """The last job made from it: ``job``, ``queued_ms``, ``phase`` and ``took_s``."""


class Files:
    """The files that a station stores, up to 1000 files of 256 MB together."""

    def __init__(self, files: _core.Files) -> None:
        self._files = files

    def list(self) -> list[StoredFile]:
        """Returns all files, the oldest first."""
        return [_stored(file) for file in json.loads(self._files.list())["files"]]

    def get(self, file: StoredFile | str | int) -> bytes:
        """Returns the content of a file, given by its name or number.

        Raises :class:`Refused` of the kind ``no-such-file`` if there is none.
        """
        return bytes(self._files.get(self._number(file)))

    def put(
        self,
        path: str | os.PathLike[str],
        content: bytes | None = None,
        *,
        existing: Existing = "refuse",
    ) -> StoredFile:
        """Stores a file of this computer, or ``content`` under the name ``path``.

        If a file of the same name has other content, ``existing`` decides. Raises :class:`Refused` of the kind
        ``file-exists``, ``file-name``, ``files-full`` or ``files-unusable``.
        """
        if content is None:
            content = FilePath(path).read_bytes()
            path = FilePath(path).name
        encoded = b64encode(content).decode()
        return _stored(json.loads(self._files.put(os.fspath(path), encoded, existing)))

    def rm(self, file: StoredFile | str | int) -> None:
        """Deletes a file, given by its name or number."""
        self._files.remove(self._number(file))

    def _number(self, file: StoredFile | str | int) -> int:
        if isinstance(file, StoredFile):
            return file.number
        if isinstance(file, int):
            return file
        named = [stored.number for stored in self.list() if stored.name == file]
        if not named:
            raise FileNotFoundError(f"the station stores no file {file!r}")
        return named[0]


def _stored(file: dict[str, Any]) -> StoredFile:
    return StoredFile(
        number=file["file"],
        name=file["name"],
        kind=file["kind"],
        revision=file["revision"],
        size=file["bytes"],
        options=file.get("options"),
        last_job=file.get("last_job"),
    )


def files(
    station: str = "station",
    *,
    token: str | None = None,
    fingerprint: str | None = None,
    ca: str | os.PathLike[str] | None = None,
) -> Files:
    """Returns the files of the station on this machine, or of the one at ``http://HOST:PORT``.

    ``token``, ``fingerprint`` and ``ca`` are as in :func:`connect`.
    """
    return Files(_core.Files(station, station_options(token, fingerprint, ca)))


def station_options(
    token: str | None, fingerprint: str | None, ca: str | os.PathLike[str] | None
) -> _core.ConnectOptions:
    """The options to find a station."""
    return {
        "name": "python", "token": token, "dialect": None, "watchdog": None,
        "fingerprint": fingerprint, "ca": None if ca is None else os.fspath(ca),
        "world": None, "faults": [], "seed": 0,
    }
