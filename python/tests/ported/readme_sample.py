"""The sample of pydobot's README: reads the pose, goes 20 mm forward and comes back."""

from dobot_arm.pydobot import Dobot

arm = Dobot(port="/dev/ttyUSB0", verbose=True)
x, y, z, r, j1, j2, j3, j4 = arm.pose()
print(f"at {x:.0f} {y:.0f} {z:.0f}, base {j1:.0f}, rear {j2:.0f}, fore {j3:.0f}, servo {j4:.0f}")
arm.move_to(x + 20, y, z, r, wait=False)
arm.move_to(x, y, z, r, wait=True)
arm.close()
