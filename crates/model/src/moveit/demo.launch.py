"""Starts MoveIt (Jazzy) and RViz for the arm: ros2 launch ./demo.launch.py, beside a running dobot-ros2."""

from pathlib import Path

import yaml
from launch import LaunchDescription
from launch_ros.actions import Node

FOLDER = Path(__file__).resolve().parent


def text(name):
    return (FOLDER / name).read_text()


def values(name):
    return yaml.safe_load(text(name))


def generate_launch_description():
    robot = {
        "robot_description": text("dobot_arm.urdf"),
        "robot_description_semantic": text("dobot_arm.srdf"),
        "robot_description_kinematics": values("kinematics.yaml"),
        "robot_description_planning": values("joint_limits.yaml"),
    }
    planning = {
        "planning_pipelines": ["ompl"],
        "default_planning_pipeline": "ompl",
        "ompl": {
            "planning_plugins": ["ompl_interface/OMPLPlanner"],
            "request_adapters": [
                "default_planning_request_adapters/ResolveConstraintFrames",
                "default_planning_request_adapters/ValidateWorkspaceBounds",
                "default_planning_request_adapters/CheckStartStateBounds",
                "default_planning_request_adapters/CheckStartStateCollision",
            ],
            "response_adapters": [
                "default_planning_response_adapters/AddTimeOptimalParameterization",
                "default_planning_response_adapters/ValidateSolution",
                "default_planning_response_adapters/DisplayMotionPath",
            ],
        },
    }
    move_group = Node(
        package="moveit_ros_move_group",
        executable="move_group",
        output="screen",
        parameters=[robot, planning, values("moveit_controllers.yaml")],
    )
    rviz = Node(
        package="rviz2",
        executable="rviz2",
        arguments=["-d", str(FOLDER / "moveit.rviz")],
        parameters=[robot],
    )
    return LaunchDescription([move_group, rviz])
