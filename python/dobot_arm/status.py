"""The status of an arm."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple


class Pose(NamedTuple):
    """The position of the tool: ``x, y, z, r = arm.pose``."""

    x_mm: float
    """Forward of the base axis."""
    y_mm: float
    """To the left of it."""
    z_mm: float
    """Above the pivot of the rear arm."""
    rotation_deg: float
    """The rotation of the tool in the base frame."""


class Joints(NamedTuple):
    """The joint angles: ``base, rear, fore, servo = arm.joints``."""

    base_deg: float
    """The base: 0 is straight ahead, positive to the left."""
    rear_deg: float
    """The rear arm, from the vertical; positive is forward."""
    fore_deg: float
    """The forearm, below the horizontal."""
    servo_deg: float
    """The servo, relative to the forearm."""


@dataclass(frozen=True)
class Status:
    """The pose of the arm and the state of its tool, in millimetres and degrees."""

    x_mm: float
    y_mm: float
    z_mm: float
    rotation_deg: float
    base_deg: float
    rear_deg: float
    fore_deg: float
    servo_deg: float
    suction: bool
    gripper_deg: float
    at_s: float = field(compare=False)
    """The time since the station started, in seconds; comparisons ignore it."""
    moving: bool = field(compare=False)
    """Whether the arm moves, or may still move; comparisons ignore it."""
