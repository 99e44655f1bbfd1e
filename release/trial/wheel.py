"""What a new user of the Python package tries first, and an arm at a serial port."""

import shutil
import sys

import dobot_arm as dobot

assert shutil.which("dobot") is None, "only the program in the wheel counts"
with dobot.connect("virtual:") as arm:
    arm.move_to(220, 0, 20)
with dobot.serve("firmware-1.1", speed=10) as served:
    with dobot.connect(f"serial:{served.serial}", dialect="firmware-1.1") as arm:
        arm.confirm_pose()
        y_mm = arm.move_to(220, 40, 20).y_mm
assert abs(y_mm - 40) < 0.5, y_mm
print(f"Python {sys.version.split()[0]}: moved an arm at a serial port to y {y_mm:.1f} mm")
