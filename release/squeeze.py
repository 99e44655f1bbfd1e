"""Compresses the files in a wheel again, as much as its format allows: `squeeze.py WHEEL`."""

import sys
import zipfile
from pathlib import Path

import zopfli

wheel = Path(sys.argv[1])
squeezed = wheel.with_suffix(".squeezed")
with zipfile.ZipFile(wheel) as files, zopfli.ZipFile(squeezed, "w", iterations=5) as out:
    for entry in files.infolist():
        out.writestr(entry, files.read(entry))
squeezed.replace(wheel)
