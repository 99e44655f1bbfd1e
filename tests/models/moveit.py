"""Checks the configuration for MoveIt with pinocchio and coal, since MoveIt needs a ROS installation.

python tests/models/moveit.py FOLDER

The folder holds TOOL.json and TOOL.csv as for check.py, and the folder TOOL.moveit, for each tool.
"""

import json
import math
import pathlib
import sys
import types
import xml.etree.ElementTree as ElementTree

import numpy as np
import pinocchio as pin
import yaml

from check import DRIVEN, TOOLS, read, within

POSES = 10_000
# KDL's solver begins again elsewhere when it does not get there.
STEPS, STARTS = 100, 30
REACHED_M = 1e-5


def main(folder):
    solved = 0
    for tool in TOOLS:
        limits = json.loads((folder / f"{tool}.json").read_text())["limits"]
        arm = Arm(folder / f"{tool}.moveit")
        launch(arm.folder)
        chain(arm)
        places = [it for it in read(folder / f"{tool}.csv") if it["allowed"]]
        starts = [arm.solve(place) for place in places]
        solved += len(starts)
        allowed = poses(arm, limits)
        assert arm.collide(allowed, "Never") == 0, tool
        # A folded arm may touch its foot.
        checked = arm.collide(allowed, None) / POSES
        assert checked < 0.05, f"{tool}: {checked:.1%} of all poses are no valid start"
        named = [[float(joint.get("value")) for joint in it] for it in arm.srdf.iter("group_state")]
        assert named and arm.collide(np.array(named), None) == 0, tool
        print(f"{tool}: IK at {len(places)} positions, {np.mean(starts):.1f} starts each; {POSES} poses, {checked:.1%} with a collision")
    assert solved >= 1000, solved


class Arm:
    """The arm of a folder: all its joints turn, those that mimic others by the matrix `spread`."""

    def __init__(self, folder):
        self.folder = folder
        urdf = folder / "dobot_arm.urdf"
        self.urdf = ElementTree.parse(urdf).getroot()
        self.srdf = ElementTree.parse(folder / "dobot_arm.srdf").getroot()
        self.model = pin.buildModelFromUrdf(str(urdf))
        self.data = self.model.createData()
        self.tool = self.model.getFrameId("tool")
        self.shapes = pin.buildGeomFromUrdf(self.model, str(urdf), pin.GeometryType.COLLISION)
        self.joints = {it.get("name"): it for it in self.urdf.iter("joint") if it.find("parent") is not None}
        self.spread = np.zeros((self.model.nq, len(DRIVEN)))
        for name, joint in self.joints.items():
            if joint.get("type") != "revolute":
                continue
            row = self.model.joints[self.model.getJointId(name)].idx_q
            mimic = joint.find("mimic")
            if mimic is None:
                self.spread[row, DRIVEN.index(name)] = 1
            else:
                self.spread[row, DRIVEN.index(mimic.get("joint"))] = float(mimic.get("multiplier"))
        limits = [self.joints[name].find("limit") for name in DRIVEN]
        self.low, self.high = (np.array([float(it.get(end)) for it in limits]) for end in ("lower", "upper"))
        self.random = np.random.default_rng(1)

    def solve(self, place):
        """Newton's method as KDL's solver does it; returns how many starts it took."""
        turn = math.radians(place["rotation_deg"])
        wanted = pin.SE3(pin.rpy.rpyToMatrix(0, 0, turn), place["at_m"])
        for start in range(1, STARTS + 1):
            angles = self.random.uniform(self.low, self.high)
            for _ in range(STEPS):
                full = self.spread @ angles
                pin.computeJointJacobians(self.model, self.data, full)
                pin.updateFramePlacements(self.model, self.data)
                off = pin.log6(self.data.oMf[self.tool].actInv(wanted)).vector
                if np.linalg.norm(off) < REACHED_M:
                    return start
                jacobian = pin.getFrameJacobian(self.model, self.data, self.tool, pin.LOCAL) @ self.spread
                angles = np.clip(angles + np.linalg.pinv(jacobian, rcond=1e-5) @ off, self.low, self.high)
        raise AssertionError(f"no solution for {place}")

    def collide(self, poses, reason):
        """How many poses have a collision of the pairs of links that have this reason; None is that of the checked pairs."""
        unchecked = {frozenset((it.get("link1"), it.get("link2"))): it.get("reason") for it in self.srdf.iter("disable_collisions")}
        link = [self.model.frames[it.parentFrame].name for it in self.shapes.geometryObjects]
        self.shapes.removeAllCollisionPairs()
        for one in range(len(link)):
            for other in range(one):
                if link[one] != link[other] and unchecked.get(frozenset((link[one], link[other]))) == reason:
                    self.shapes.addCollisionPair(pin.CollisionPair(other, one))
        assert len(self.shapes.collisionPairs) > 0, reason
        found = self.shapes.createData()
        return sum(pin.computeCollisions(self.model, self.data, self.shapes, found, self.spread @ it, True) for it in poses)


def poses(arm, limits):
    """Poses that the arm allows, spread over all of them."""
    found = []
    while len(found) < POSES:
        angles = arm.random.uniform(arm.low, arm.high)
        pin.framesForwardKinematics(arm.model, arm.data, arm.spread @ angles)
        x, y, z = arm.data.oMf[arm.tool].translation * 1000
        opening = math.degrees(angles[1] - angles[2])
        if within(opening, *limits["rear_minus_fore_deg"]) and within(math.hypot(x, y), *limits["reach_mm"]) and within(z, *limits["z_mm"]):
            found.append(angles)
    return found


def chain(arm):
    """KDL's rule: the group is one chain, and all its driven joints are in it, so that a target has a solution."""
    group = next(it for it in arm.srdf.iter("group") if it.get("name") == "arm").find("chain")
    parents = {it.find("child").get("link"): it for it in arm.joints.values()}
    link, driven = group.get("tip_link"), []
    assert link == "tool"
    while link != group.get("base_link"):
        joint = parents[link]
        if joint.find("mimic") is None:
            driven.insert(0, joint.get("name"))
        else:
            assert joint.find("mimic").get("joint") in DRIVEN, joint.get("name")
        link = joint.find("parent").get("link")
    assert driven == DRIVEN, driven
    states = {it.get("name"): [j.get("name") for j in it] for it in arm.srdf.iter("group_state")}
    assert states and all(it == DRIVEN for it in states.values()), states
    links = {it.get("name") for it in arm.urdf.iter("link")}
    named = {it.get(end) for it in arm.srdf.iter("disable_collisions") for end in ("link1", "link2")}
    assert named <= links, named - links
    limits = yaml.safe_load((arm.folder / "joint_limits.yaml").read_text())["joint_limits"]
    assert list(limits) == DRIVEN, limits
    for name, limit in limits.items():
        assert 0 < limit["max_velocity"] <= float(arm.joints[name].find("limit").get("velocity")), name
        assert limit["has_acceleration_limits"] and limit["max_acceleration"] > 0, name


def launch(folder):
    """Runs the launch file with stand-ins for ROS's modules: it finds its files, and each is what it should be."""
    started = {}
    modules = {name: types.ModuleType(name) for name in ("launch", "launch_ros", "launch_ros.actions")}
    modules["launch"].LaunchDescription = list
    modules["launch_ros.actions"].Node = lambda **words: started.setdefault(words["executable"], words)
    sys.modules.update(modules)
    file = folder / "demo.launch.py"
    scope = {"__file__": str(file)}
    exec(compile(file.read_text(), file, "exec"), scope)
    assert len(scope["generate_launch_description"]()) == 2
    robot, planning, controllers = started["move_group"]["parameters"]
    assert "<robot" in robot["robot_description"] and "<group_state" in robot["robot_description_semantic"]
    assert robot["robot_description_kinematics"]["arm"]["kinematics_solver"].endswith("KDLKinematicsPlugin")
    assert controllers["moveit_simple_controller_manager"]["dobot"]["joints"] == DRIVEN, controllers
    layout = yaml.safe_load(pathlib.Path(started["rviz2"]["arguments"][1]).read_text())
    assert layout["Visualization Manager"]["Global Options"]["Fixed Frame"] == "base"


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
