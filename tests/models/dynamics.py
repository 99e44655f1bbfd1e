"""Holds and moves the arm against gravity in physics engines: its URDF in PyBullet and in Drake.

python tests/models/dynamics.py FOLDER

The folder holds TOOL.urdf and TOOL.csv as for check.py. With the efforts of the URDF, motors at the driven joints bring the
tool to places that our kinematics calculated; the joints that mimic others follow by what the engine has for that.
"""

import contextlib
import math
import os
import pathlib
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

import numpy as np
import pybullet
from pydrake.all import (
    AddMultibodyPlantSceneGraph,
    CollisionFilterDeclaration,
    DiagramBuilder,
    DiscreteContactApproximation,
    GeometrySet,
    Parser,
    PdControllerGains,
    Simulator,
)

from check import DRIVEN, TOOLS, read

PLACES = 3
STEP_S = 0.001
TAKES_S = 1.5
# What motors with finite stiffness give way to the weight.
ALLOWED_M = 0.002


def main(folder):
    for tool in TOOLS:
        urdf = folder / f"{tool}.urdf"
        places = [it for it in read(folder / f"{tool}.csv") if it["allowed"]][:PLACES]
        for name, engine in {"PyBullet": bullet, "Drake": drake}.items():
            worst = max(np.linalg.norm(engine(urdf, place) - place["at_m"]) for place in places)
            assert worst <= ALLOWED_M, f"{tool}: {name} ends {worst} m apart; allowed are {ALLOWED_M}"
            print(f"{tool}: {name} brings the tool to {len(places)} places, {worst:.1e} m apart at most")


def target(place, share):
    """From 0, where the arm stands upright, to a place."""
    return {name: math.radians(place["joints"][name]) * share for name in DRIVEN}


def bullet(urdf, place):
    """Motors turn the joints that mimic others too. Without the flag PyBullet makes inertias from shapes."""
    world = pybullet.connect(pybullet.DIRECT)
    with printed() as lines:
        robot = pybullet.loadURDF(str(urdf), useFixedBase=True, flags=pybullet.URDF_USE_INERTIA_FROM_FILE, physicsClientId=world)
    assert not lines, lines
    pybullet.setGravity(0, 0, -9.81, physicsClientId=world)
    pybullet.setPhysicsEngineParameter(fixedTimeStep=STEP_S, numSolverIterations=200, physicsClientId=world)
    info = [pybullet.getJointInfo(robot, n, physicsClientId=world) for n in range(pybullet.getNumJoints(robot, physicsClientId=world))]
    joints = {it[1].decode(): it for it in info}
    links = {it[12].decode(): it[0] for it in info}
    mimics = {it.get("name"): it.find("mimic") for it in ElementTree.parse(urdf).getroot().iter("joint") if it.find("mimic") is not None}
    for step in range(round(1.5 * TAKES_S / STEP_S)):
        wanted = target(place, min(1, step * STEP_S / TAKES_S))
        for name, joint in joints.items():
            if joint[2] != pybullet.JOINT_REVOLUTE:
                continue
            mimic = mimics.get(name)
            angle = wanted[name] if mimic is None else wanted[mimic.get("joint")] * float(mimic.get("multiplier"))
            assert joint[10] > 0, f"{name} has no effort"
            pybullet.setJointMotorControl2(
                robot, joint[0], pybullet.POSITION_CONTROL, targetPosition=angle, force=joint[10], physicsClientId=world
            )
        pybullet.stepSimulation(physicsClientId=world)
    at = pybullet.getLinkState(robot, links["tool"], computeForwardKinematics=True, physicsClientId=world)[4]
    pybullet.disconnect(world)
    return np.array(at)


@contextlib.contextmanager
def printed():
    """The lines that the engine, which is not written in Python, prints."""
    lines = []
    with tempfile.TemporaryFile() as file:
        kept = [os.dup(1), os.dup(2)]
        for number in (1, 2):
            os.dup2(file.fileno(), number)
        try:
            yield lines
        finally:
            for number, old in zip((1, 2), kept):
                os.dup2(old, number)
                os.close(old)
            file.seek(0)
            lines += file.read().decode().splitlines()


def drake(urdf, place):
    """Drake makes couplers of the joints that mimic others, and motors of the transmissions."""
    builder = DiagramBuilder()
    plant, scene = AddMultibodyPlantSceneGraph(builder, STEP_S)
    plant.set_discrete_contact_approximation(DiscreteContactApproximation.kSap)
    (robot,) = Parser(plant).AddModels(str(urdf))
    plant.WeldFrames(plant.world_frame(), plant.GetFrameByName("base"))
    assert plant.num_actuators() == len(DRIVEN), plant.num_actuators()
    for name in DRIVEN:
        motor = plant.GetJointActuatorByName(name)
        assert motor.effort_limit() > 0, name
        motor.set_controller_gains(PdControllerGains(p=2000, d=20))
    plant.Finalize()
    # The parts of the linkage touch each other.
    shapes = GeometrySet(scene.model_inspector().GetAllGeometryIds())
    scene.collision_filter_manager().Apply(CollisionFilterDeclaration().ExcludeWithin(shapes))
    order = [plant.get_joint_actuator(n).joint().name() for n in plant.GetJointActuatorIndices(robot)]
    diagram = builder.Build()
    simulator = Simulator(diagram)
    context = plant.GetMyMutableContextFromRoot(simulator.get_mutable_context())
    port = plant.get_desired_state_input_port(robot)
    steps = 50
    for step in range(1, 2 * steps + 1):
        wanted = target(place, min(1, step / steps))
        angles = [wanted[name] for name in order]
        port.FixValue(context, np.concatenate([angles, np.zeros(len(angles))]))
        simulator.AdvanceTo(step * TAKES_S / steps)
    return plant.GetFrameByName("tool").CalcPoseInWorld(context).translation()


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]))
