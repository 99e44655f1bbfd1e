"""Checks the models of the arm with programs of others: its URDF with yourdfpy, its MJCF with MuJoCo, its JSON by hand.

python tests/models/check.py FOLDER

The folder holds TOOL.urdf, TOOL.xml, TOOL.json and TOOL.csv for each tool: the models, and places that our kinematics
calculated. The frames `tool` and `tip` must be there to 1e-6 m, the loops of the linkage closed, and the limits those by
which our code judges. `none.*` are the models without a tool.
"""

import csv
import json
import math
import pathlib
import sys

import mujoco
import numpy as np
import yourdfpy

DRIVEN = ["base", "rear", "fore", "servo"]
ALLOWED_M = 1e-6
SETTLED_M = 1e-5
ROUNDING = 1e-9
TOOLS = ["cup", "gripper", "pen", "laser"]
# Places to which MuJoCo's own motors take the arm.
DRIVES = 5


def main(folder):
    for tool in TOOLS:
        places = read(folder / f"{tool}.csv")
        assert len(places) == 1000, f"{tool}: {len(places)} places"
        model = json.loads((folder / f"{tool}.json").read_text())
        down_m = model["tool"]["length_mm"] / 1000
        worst = {
            "URDF": urdf(folder / f"{tool}.urdf", places, down_m),
            "MJCF": mjcf(folder / f"{tool}.xml", places, down_m, model),
            "JSON": by_hand(model, places),
        }
        for what, apart_m in worst.items():
            assert apart_m <= ALLOWED_M, f"{tool}, {what}: {apart_m} m apart; allowed are {ALLOWED_M}"
        driven_m = drive(folder / f"{tool}.xml", [it for it in places if it["allowed"]])
        assert driven_m <= SETTLED_M, f"{tool}: MuJoCo's motors end {driven_m} m apart; allowed are {SETTLED_M}"
        allowed = sum(it["allowed"] for it in places)
        reported = ", ".join(f"{what} {apart_m:.1e}" for what, apart_m in worst.items())
        print(f"{tool}: {len(places)} places, {allowed} allowed; apart in m: {reported}; driven {driven_m:.1e}")
    without(folder)


def read(file):
    with file.open() as lines:
        rows = list(csv.DictReader(lines))
    for row in rows:
        row["allowed"] = row["allowed"] == "true"
        for name in row.keys() - {"allowed"}:
            row[name] = float(row[name])
        row["joints"] = {name: row[f"{name}_deg"] for name in DRIVEN}
        row["at_m"] = np.array([row["x_mm"], row["y_mm"], row["z_mm"]]) / 1000
    return rows


def apart(found, below, place, down_m):
    """How far the frames `tool` and `tip` are from where they should be."""
    turn = math.radians(place["rotation_deg"])
    ahead = place["at_m"] + [math.cos(turn), math.sin(turn), 0]
    tip = place["at_m"] - [0, 0, down_m]
    return max(
        np.linalg.norm(found[:3, 3] - place["at_m"]),
        np.linalg.norm(found[:3, 3] + found[:3, 0] - ahead),
        np.linalg.norm(below[:3, 3] - tip),
    )


def urdf(file, places, down_m):
    robot = yourdfpy.URDF.load(str(file), load_meshes=False, build_collision_scene_graph=False)
    assert robot.validate(), robot.errors
    assert robot.actuated_joint_names == ["base", "rear", "fore", "servo"], robot.actuated_joint_names
    spans = {name: robot.joint_map[name].limit for name in DRIVEN}
    worst = 0
    for place in places:
        robot.update_cfg({name: math.radians(deg) for name, deg in place["joints"].items()})
        if place["allowed"]:
            for name, joint in robot.joint_map.items():
                if joint.type == "revolute":
                    angle = turned(joint, place["joints"])
                    assert joint.limit.lower - ROUNDING <= angle <= joint.limit.upper + ROUNDING, f"{name}: {angle}"
        worst = max(worst, apart(robot.get_transform("tool"), robot.get_transform("tip"), place, down_m))
    for name, span in spans.items():
        assert span.velocity > 0, name
    return worst


def turned(joint, joints):
    """The angle of a joint of a URDF in radians."""
    if joint.mimic is None:
        return math.radians(joints[joint.name])
    return joint.mimic.multiplier * math.radians(joints[joint.mimic.joint]) + joint.mimic.offset


def mjcf(file, places, down_m, reported):
    """All joints are set; the pins must hold as they are."""
    model = mujoco.MjModel.from_xml_path(str(file))
    data = mujoco.MjData(model)
    worst = 0
    for place in places:
        for joint in reported["joints"]:
            if "axis" in joint:
                data.joint(joint["name"]).qpos = math.radians(angle(joint, place["joints"]))
        mujoco.mj_forward(model, data)
        worst = max(worst, apart(frame(data, "tool"), frame(data, "tip"), place, down_m))
        pins = data.efc_pos[data.efc_type == mujoco.mjtConstraint.mjCNSTR_EQUALITY]
        assert len(pins) == 9, pins
        worst = max(worst, np.abs(pins).max())
        if place["allowed"]:
            stops = np.isin(data.efc_type, [mujoco.mjtConstraint.mjCNSTR_LIMIT_JOINT, mujoco.mjtConstraint.mjCNSTR_LIMIT_TENDON])
            assert not (data.efc_pos[stops] < -ROUNDING).any(), place
            assert data.ncon == 0, place
    return worst


def frame(data, name):
    found = np.eye(4)
    found[:3, 3] = data.site(name).xpos
    found[:3, :3] = data.site(name).xmat.reshape(3, 3)
    return found


def drive(file, places):
    """From its rest MuJoCo's motors turn the driven joints alone; the pins turn the others."""
    model = mujoco.MjModel.from_xml_path(str(file))
    worst = 0
    for place in places[:DRIVES]:
        data = mujoco.MjData(model)
        start = dict.fromkeys(DRIVEN, 0)
        for step in range(6000):
            share = min(1, step / 2000)
            for name in DRIVEN:
                data.actuator(name).ctrl = math.radians(start[name] + (place["joints"][name] - start[name]) * share)
            mujoco.mj_step(model, data)
        mujoco.mj_forward(model, data)
        worst = max(worst, np.linalg.norm(frame(data, "tool")[:3, 3] - place["at_m"]))
    return worst


def angle(joint, joints):
    """The angle of a joint of the JSON in degrees."""
    if "follows" in joint:
        return sum(times * joints[name] for name, times in joint["follows"].items())
    return joints[joint["name"]]


def by_hand(model, places):
    """The tree of the JSON, multiplied out, and its limits, which must judge as our code does."""
    down_m = model["tool"]["length_mm"] / 1000
    limits = model["limits"]
    worst = 0
    for place in places:
        frames = {"base": np.eye(4)}
        waiting = list(model["joints"])
        while waiting:
            joint = next(it for it in waiting if it["parent"] in frames)
            waiting.remove(joint)
            frames[joint["child"]] = frames[joint["parent"]] @ moved(joint, place["joints"])
        worst = max(worst, apart(frames["tool"], frames["tip"], place, down_m))
        for pin in model["pins"]:
            one, other = ((frames[link] @ [*np.array(at) / 1000, 1])[:3] for link, at in zip(pin["links"], pin["at_mm"]))
            worst = max(worst, np.linalg.norm(one - other))
        joints = place["joints"]
        measures = {f"{name}_deg": deg for name, deg in joints.items()}
        measures["rear_minus_fore_deg"] = joints["rear"] - joints["fore"]
        measures["reach_mm"] = math.hypot(place["x_mm"], place["y_mm"])
        measures["z_mm"] = place["z_mm"]
        assert measures.keys() == limits.keys(), limits.keys()
        allowed = all(within(measures[name], *limits[name]) for name in limits)
        assert allowed == place["allowed"], place
    return worst


def within(value, least, most):
    return (least is None or value >= least - ROUNDING) and (most is None or value <= most + ROUNDING)


def moved(joint, joints):
    matrix = np.eye(4)
    matrix[:3, 3] = np.array(joint["at_mm"]) / 1000
    if "axis" in joint:
        turn = math.radians(angle(joint, joints))
        cos, sin = math.cos(turn), math.sin(turn)
        about = {"y": [[cos, 0, sin], [0, 1, 0], [-sin, 0, cos]], "z": [[cos, -sin, 0], [sin, cos, 0], [0, 0, 1]]}
        matrix[:3, :3] = about[joint["axis"]]
    return matrix


def without(folder):
    robot = yourdfpy.URDF.load(str(folder / "none.urdf"), load_meshes=False)
    assert robot.actuated_joint_names == ["base", "rear", "fore"], robot.actuated_joint_names
    assert mujoco.MjModel.from_xml_path(str(folder / "none.xml")).nu == 3
    assert json.loads((folder / "none.json").read_text())["tool"] is None


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
