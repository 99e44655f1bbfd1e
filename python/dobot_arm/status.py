"""The status of an arm."""

from __future__ import annotations

from dataclasses import dataclass


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
