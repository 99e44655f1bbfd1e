"""What a new user of the Python package tries first, and an arm at a serial port."""

import shutil
import sys

import dobot_arm as dobot

assert shutil.which("dobot") is None, "only the program in the wheel counts"
with dobot.connect("virtual:") as arm:
    arm.move_to(220, 0, 20)
with dobot.serve(serial=True) as served:
    with dobot.connect(f"serial:{served.serial}", dialect="specification") as arm:
        print(f"Python {sys.version.split()[0]}: at a serial port, {arm.status()}")
