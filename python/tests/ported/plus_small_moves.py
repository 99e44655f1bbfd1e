"""A script for pydobotplus: a ready position, steps along each axis, and back by a relative move."""

from dobot_arm.pydobotplus import MODE_PTP, CustomPosition, Dobot

READY = CustomPosition(x=210, y=0, z=40, r=0)
arm = Dobot(port="/dev/ttyACM0")
arm.clear_alarms()
arm.speed(50, 50)
arm.move_to(position=READY)
for x, y, z in [(220, 0, 40), (220, 10, 40), (220, 10, 50)]:
    arm.move_to(x=x, y=y, z=z, r=0)
(position, joints) = arm.get_pose()
assert abs(position.x - 220) < 1 and abs(position.z - 50) < 1, position
arm.move_rel(x=-10, y=-10, z=-10)
arm.move_to(x=230, mode=MODE_PTP.MOVL_XYZ)
arm.close()
