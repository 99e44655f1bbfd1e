"""Jogs the tool up, twenty times a second, until it is killed."""

import sys
import time

import messages as m
from robot import Robot

robot = Robot(int(sys.argv[1]))
while True:
    robot.twist.write(m.TwistStamped(m.Header(frame_id="base"), m.Twist(m.Vector3(0.0, 0.0, 0.03))))
    time.sleep(0.05)
