"""Compares a copy in protobuf with its recording, by PyPI's `mcap` and Foxglove's own classes, and opens it with Rerun.

python tests/recordings/protobuf.py RECORDING COPY

Every message of the copy is that of the recording. Rerun shows the pose and the places of the links, and decodes target and ink.
"""

import datetime
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from foxglove_schemas_protobuf import FrameTransforms_pb2, PoseInFrame_pb2, SceneUpdate_pb2
from google.protobuf.json_format import MessageToDict, ParseDict
from mcap.reader import make_reader
from mcap_protobuf.decoder import DecoderFactory

KNOWN = {
    "/arm/pose": PoseInFrame_pb2.PoseInFrame,
    "/tf": FrameTransforms_pb2.FrameTransforms,
    "/arm/target": SceneUpdate_pb2.SceneUpdate,
    "/arm/ink": SceneUpdate_pb2.SceneUpdate,
}


def main(recording, copy):
    counts = compare(recording, copy)
    with tempfile.TemporaryDirectory() as folder:
        rerun = look_with_rerun(copy, pathlib.Path(folder))
    print(f"protobuf: {counts} messages as in the recording; Rerun reads {', '.join(sorted(rerun))}")


def messages(path):
    with path.open("rb") as file:
        return list(make_reader(file, validate_crcs=True, decoder_factories=[DecoderFactory()]).iter_messages())


def compare(recording, copy):
    before, after = messages(recording), messages(copy)
    assert len(before) == len(after), (len(before), len(after))
    factory, converted = DecoderFactory(), dict.fromkeys(KNOWN, 0)
    for (_, channel, expected), (schema, now, found) in zip(before, after):
        topic = channel.topic
        assert (topic, expected.log_time, expected.publish_time) == (now.topic, found.log_time, found.publish_time)
        if topic not in KNOWN:
            assert found.data == expected.data and now.message_encoding == "json", topic
            continue
        converted[topic] += 1
        assert (schema.encoding, now.message_encoding) == ("protobuf", "protobuf"), topic
        wanted = ParseDict(plain(json.loads(expected.data)), KNOWN[topic]())
        assert is_same(MessageToDict(KNOWN[topic].FromString(found.data)), MessageToDict(wanted)), (topic, wanted)
        # The schema in the file is enough to read it.
        decoded = factory.decoder_for("protobuf", schema)(found.data)
        assert decoded.DESCRIPTOR.full_name == schema.name == KNOWN[topic].DESCRIPTOR.full_name
    assert all(converted.values()), converted
    return sum(converted.values())


def is_same(one, other):
    """Whether two messages are the same, but for the last digit of a number."""
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(is_same(one[key], other[key]) for key in one)
    if isinstance(one, list):
        return len(one) == len(other) and all(map(is_same, one, other))
    return math.isclose(one, other, rel_tol=1e-14) if isinstance(one, float) else one == other


def plain(value, name=None):
    """JSON as protobuf writes it: moments as text."""
    if isinstance(value, list):
        return [plain(item) for item in value]
    if not isinstance(value, dict):
        return value
    if value.keys() == {"sec", "nsec"}:
        if name == "lifetime":
            return f"{value['sec']}.{value['nsec']:09}s"
        moment = datetime.datetime.fromtimestamp(value["sec"], datetime.timezone.utc)
        return f"{moment:%Y-%m-%dT%H:%M:%S}.{value['nsec']:09}Z"
    return {key: plain(item, key) for key, item in value.items()}


def look_with_rerun(copy, folder):
    """The topics that Rerun reads, by the columns that it makes of them."""
    program, out = pathlib.Path(sys.executable).with_name("rerun"), folder / "copy.rrd"

    def run(*arguments):
        # It keeps its settings in the home folder.
        return subprocess.run([program, *arguments], check=True, capture_output=True, text=True, env={"HOME": str(folder)}).stdout

    run("mcap", "convert", str(copy), "-o", str(out))
    made = run("rrd", "print", "-v", str(out))
    missing = [column for columns in COLUMNS.values() for column in columns if column not in made]
    assert not missing, (missing, made[-3000:])
    return COLUMNS


COLUMNS = {
    "/arm/pose": ["/arm/pose@InstancePoses3D:translations", "/arm/pose@InstancePoses3D:quaternions"],
    "/tf": ["/tf@Transform3D:child_frame", "/tf@Transform3D:translation", "/tf@Transform3D:quaternion"],
    "/arm/target": ["/arm/target@foxglove.SceneUpdate:message"],
    "/arm/ink": ["/arm/ink@foxglove.SceneUpdate:message"],
}

main(*map(pathlib.Path, sys.argv[1:]))
