"""A class's script for a fork of pydobot: takes a block with the suction cup and sets it down on the other side."""

from dobot_arm.pydobot import Dobot

SAFE = 35
TOP = -15
arm = Dobot(port="/dev/ttyUSB0")
print("pose:", arm.get_pose())
arm.speed(80, 80)
arm.move_to(x=200, y=60, z=TOP + SAFE, r=0, wait=True)
arm.move_to(x=200, y=60, z=TOP, r=0, wait=True)
arm.suck(True)
arm.wait(500)
arm.move_to(x=200, y=60, z=TOP + SAFE, r=0)
arm.move_to(x=200, y=-60, z=TOP + SAFE, r=0)
arm.move_to(x=200, y=-60, z=TOP + 1, r=0, wait=True)
arm.suck(False)
arm.wait(500)
arm.move_to(x=200, y=-60, z=TOP + SAFE, r=0, wait=True)
arm.close()
