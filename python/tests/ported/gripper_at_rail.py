"""A fork's script without its rail: opens the gripper, goes down straight, grips and lifts."""

from dobot_arm.pydobot import Dobot

arm = Dobot(port="COM4")
x, y, z, r, *_ = arm.pose()
arm.grip(False)
arm.move_to(230, 25, 20, 50, wait=True)
arm.move_to(230, 25, -30, 50, wait=True)
arm.grip(True)
arm.wait(500)
arm.move_to(230, 25, 20, 50, wait=True)
arm.close()
