"""Packs a folder into a .tar.xz or .zip that depends on nothing but the files: `pack.py FOLDER ARCHIVE`."""

import lzma
import os
import sys
import tarfile
import time
import zipfile
from pathlib import Path

DATE = int(os.environ["SOURCE_DATE_EPOCH"])


def plain(entry: tarfile.TarInfo) -> tarfile.TarInfo:
    """Removes owner and date."""
    entry.uid = entry.gid = 0
    entry.uname = entry.gname = ""
    entry.mtime = DATE
    entry.mode = 0o755 if entry.isdir() or entry.mode & 0o100 else 0o644
    return entry


def tar(folder: Path, files: list[Path], archive: Path) -> None:
    with lzma.open(archive, "wb", preset=9) as packed, tarfile.open(fileobj=packed, mode="w", format=tarfile.USTAR_FORMAT) as out:
        for path in files:
            out.add(path, path.relative_to(folder.parent), recursive=False, filter=plain)


def zipped(folder: Path, files: list[Path], archive: Path) -> None:
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED, compresslevel=9) as out:
        for path in files:
            if path.is_file():
                entry = zipfile.ZipInfo(path.relative_to(folder.parent).as_posix(), time.gmtime(DATE)[:6])
                entry.compress_type = zipfile.ZIP_DEFLATED
                entry.external_attr = 0o100644 << 16
                out.writestr(entry, path.read_bytes(), compresslevel=9)


folder, archive = map(Path, sys.argv[1:])
files = [folder, *sorted(folder.rglob("*"))]
(zipped if archive.suffix == ".zip" else tar)(folder, files, archive)
