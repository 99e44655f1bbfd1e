"""A drawing script for pydobot: a triangle with pen up and pen down at two heights."""

from dobot_arm.pydobot import Dobot

PEN_UP = -20
PEN_DOWN = -40
CORNERS = [(200, -20), (240, -20), (220, 20)]

arm = Dobot(port="/dev/ttyUSB0")
arm.speed(100, 100)
first = CORNERS[0]
arm.move_to(*first, PEN_UP, 0, wait=True)
arm.move_to(*first, PEN_DOWN, 0, wait=True)
for corner in [*CORNERS[1:], first]:
    arm.move_to(*corner, PEN_DOWN, 0)
arm.move_to(*first, PEN_UP, 0, wait=True)
arm.close()
