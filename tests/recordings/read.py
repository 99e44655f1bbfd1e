"""Reads each recording of a folder with PyPI's `mcap`, by its index, and counts its messages.

python tests/recordings/read.py FOLDER

Beside each FILE.mcap stands FILE.mcap.count: how many messages it has.
"""

import json
import pathlib
import sys

from mcap.reader import make_reader

paths = sorted(pathlib.Path(sys.argv[1]).glob("*.mcap"))
if not paths:
    sys.exit(f"there is no recording in {sys.argv[1]}")
for path in paths:
    expected = int(path.with_name(path.name + ".count").read_text())
    with path.open("rb") as file:
        reader = make_reader(file, validate_crcs=True)
        found = 0
        for schema, channel, message in reader.iter_messages():
            assert schema.encoding == "jsonschema", f"{path}: {channel.topic}"
            json.loads(message.data)
            found += 1
        indexed = reader.get_summary().statistics.message_count
    if not found == indexed == expected:
        sys.exit(f"{path}: {found} messages, {indexed} by its index; expected are {expected}")
print(f"{len(paths)} recordings, each whole")
