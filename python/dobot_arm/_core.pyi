from typing import TypedDict

class Told(TypedDict):
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

class Core:
    def __new__(cls, at: str, name: str, token: str | None) -> Core: ...
    def status(self) -> Told: ...
    def move_to(
        self,
        point_mm: tuple[float, float, float],
        rotation_deg: float | None,
        path: str,
        suction: bool | None,
        gripper_deg: float | None,
        pause_s: float,
    ) -> Told: ...
    def move_joints(
        self,
        joints_deg: tuple[float, float, float],
        servo_deg: float | None,
        path: str,
        suction: bool | None,
        gripper_deg: float | None,
        pause_s: float,
    ) -> Told: ...
    def wait(self, seconds: float) -> None: ...
    def confirm_pose(self) -> None: ...
    def reset_stop(self) -> None: ...
    def stop(self, reason: str | None) -> None: ...
    def close(self) -> None: ...
