"""Reads the recording of a station that went to a place and drew the square of 30 mm, with PyPI's `mcap`.

python tests/recordings/scene.py FOLDER

The links of the arm bring its tool to the pose that the arm reported, the target was where the arm was sent, and the ink is
that square.
"""

import json
import math
import pathlib
import sys

from mcap.reader import make_reader

(path,) = sorted(pathlib.Path(sys.argv[1]).glob("*.mcap"))
reported, schemas = {}, {}
with path.open("rb") as file:
    for schema, channel, message in make_reader(file, validate_crcs=True).iter_messages():
        schemas[channel.topic] = (schema.name, json.loads(schema.data))
        reported.setdefault(channel.topic, []).append((message.log_time, json.loads(message.data)))
for topic, name in [
    ("/tf", "foxglove.FrameTransforms"),
    ("/arm/target", "foxglove.SceneUpdate"),
    ("/arm/ink", "foxglove.SceneUpdate"),
]:
    assert schemas[topic][0] == name, (topic, schemas[topic][0])


def fits(value, schema, where):
    """Whether a value is as its schema says: whoever shows it goes by that."""
    kinds = {"object": dict, "array": list, "string": str, "integer": int, "number": (int, float), "boolean": bool}
    assert isinstance(value, kinds[schema["type"]]), (where, value)
    for name in schema.get("required", []):
        assert name in value, (where, name)
    if schema["type"] == "object":
        for name, part in schema.get("properties", {}).items():
            if name in value:
                fits(value[name], part, f"{where}.{name}")
    if schema["type"] == "array":
        for item in value:
            fits(item, schema["items"], f"{where}[]")


for topic in ["/tf", "/arm/target", "/arm/ink"]:
    for _, value in reported[topic]:
        fits(value, schemas[topic][1], topic)


def place(transforms, frame):
    """Where the origin of a link is in the frame `base`."""
    at = [0.0, 0.0, 0.0]
    while frame != "base":
        (link,) = [it for it in transforms if it["child_frame_id"] == frame]
        x, y, z, w = (link["rotation"][it] for it in "xyzw")
        rows = [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
        turned = [sum(a * b for a, b in zip(row, at)) for row in rows]
        at = [link["translation"][axis] + it for axis, it in zip("xyz", turned)]
        frame = link["parent_frame_id"]
    return at


poses = {at: value["pose"]["position"] for at, value in reported["/arm/pose"]}
furthest = 0.0
for at, value in reported["/tf"]:
    expected = [poses[at][axis] for axis in "xyz"]
    furthest = max(furthest, math.dist(place(value["transforms"], "tool"), expected))
assert furthest < 1e-6, f"the tool is {furthest} m from the pose"
tip_m = -[it for it in reported["/tf"][-1][1]["transforms"] if it["child_frame_id"] == "tip"][0]["translation"]["z"]

aim = reported["/arm/target"][0][1]["entities"][0]["spheres"][0]["pose"]["position"]
assert math.dist([aim[it] for it in "xyz"], [0.22, 0.05, 0.03 - tip_m]) < 2e-5, aim

entities = [it for _, value in reported["/arm/ink"] for it in value["entities"]]
assert len({it["id"] for it in entities}) == len(entities)
lines = [[[p[axis] for axis in "xyz"] for p in line["points"]] for it in entities for line in it["lines"]]
points = [point for line in lines for point in line]
(x0, x1), (y0, y1) = ((min(them), max(them)) for them in list(zip(*points))[:2])
assert abs(x1 - x0 - 0.03) < 1e-4 and abs(y1 - y0 - 0.03) < 1e-4, (x0, x1, y0, y1)
for x, y, z in points:
    assert min(abs(x - x0), abs(x - x1), abs(y - y0), abs(y - y1)) < 1e-4, (x, y)
    assert abs(z - (-0.04 - tip_m)) < 1e-5, z
drawn_m = sum(math.dist(a, b) for line in lines for a, b in zip(line, line[1:]))
assert abs(drawn_m - 0.12) < 2e-4, f"{drawn_m} m are drawn"
print(f"{len(reported['/tf'])} places of {len(reported['/tf'][-1][1]['transforms'])} links, {len(lines)} pieces of ink: read")
