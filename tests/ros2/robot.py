"""What a program of ROS 2 does with an arm: topics, services and the action, over DDS alone."""

import math
import os
import time
import uuid

# DDS takes part on the loopback alone, whatever other networks there are.
os.environ.setdefault(
    "CYCLONEDDS_URI",
    '<CycloneDDS><Domain><General><AllowMulticast>false</AllowMulticast><Interfaces><NetworkInterface name="lo"/>'
    '</Interfaces></General><Discovery><ParticipantIndex>auto</ParticipantIndex><Peers><Peer address="127.0.0.1"/>'
    "</Peers></Discovery></Domain></CycloneDDS>",
)

from cyclonedds.core import DDSStatus, InstanceState, ReadCondition, SampleState, ViewState, WaitSet  # noqa: E402
from cyclonedds.domain import DomainParticipant  # noqa: E402
from cyclonedds.pub import DataWriter  # noqa: E402
from cyclonedds.qos import Policy, Qos  # noqa: E402
from cyclonedds.sub import DataReader  # noqa: E402
from cyclonedds.topic import Topic  # noqa: E402
from cyclonedds.util import duration  # noqa: E402

import messages as m  # noqa: E402

RELIABLE = Policy.Reliability.Reliable(duration(seconds=1))
LATEST = Qos(RELIABLE, Policy.History.KeepLast(100))
KEPT = Qos(RELIABLE, Policy.History.KeepLast(1), Policy.Durability.TransientLocal)
PATIENCE_S = 20


class Robot:
    """The arm, as a program of ROS 2 sees it."""

    def __init__(self, domain, namespace=""):
        self.participant = DomainParticipant(domain)
        self.namespace = namespace
        self.joint_states = self.reader(f"rt{namespace}/joint_states", m.JointState)
        self.tf = self.reader("rt/tf", m.TFMessage)
        self.diagnostics = self.reader("rt/diagnostics", m.DiagnosticArray)
        self.rosout = self.reader("rt/rosout", m.Log)
        node = f"{namespace}/dobot"
        self.target = self.writer(f"rt{node}/target", m.PoseStamped)
        self.twist = self.writer(f"rt{node}/delta_twist_cmds", m.TwistStamped)
        self.jog = self.writer(f"rt{node}/delta_joint_cmds", m.JointJog)
        self.stop = Service(self, f"{node}/stop", m.TriggerRequest, m.TriggerResponse)
        self.suction = Service(self, f"{node}/suction", m.SetBoolRequest, m.SetBoolResponse)
        self.gripper = Service(self, f"{node}/gripper", m.SetBoolRequest, m.SetBoolResponse)
        action = f"{node}/follow_joint_trajectory/_action"
        self.send_goal = Service(self, f"{action}/send_goal", m.SendGoalRequest, m.SendGoalResponse)
        self.get_result = Service(self, f"{action}/get_result", m.GetResultRequest, m.GetResultResponse)
        self.cancel_goal = Service(self, f"{action}/cancel_goal", m.CancelGoalRequest, m.CancelGoalResponse)
        gripper = f"{node}/gripper_command/_action"
        self.send_gripper = Service(self, f"{gripper}/send_goal", m.GripperSendGoalRequest, m.GripperSendGoalResponse)
        self.gripper_result = Service(self, f"{gripper}/get_result", m.GripperGetResultRequest, m.GripperGetResultResponse)
        self.list_parameters = Service(self, f"{node}/list_parameters", m.ListParametersRequest, m.ListParametersResponse)
        self.get_parameters = Service(self, f"{node}/get_parameters", m.GetParametersRequest, m.GetParametersResponse)
        self.describe_parameters = Service(
            self, f"{node}/describe_parameters", m.DescribeParametersRequest, m.DescribeParametersResponse
        )
        self.set_parameters = Service(self, f"{node}/set_parameters", m.SetParametersRequest, m.SetParametersResponse)
        self.pose = self.reader(f"rt{node}/pose", m.PoseStamped)
        self.feedback = self.reader(f"rt{action}/feedback", m.FollowFeedbackMessage)

    def reader(self, name, kind, qos=LATEST):
        return DataReader(self.participant, Topic(self.participant, name, kind), qos=qos)

    def writer(self, name, kind, qos=LATEST):
        return DataWriter(self.participant, Topic(self.participant, name, kind), qos=qos)

    def joints(self):
        """The next angles of the joints that are reported, in radians."""
        drop(self.joint_states)
        state = first(self.joint_states)
        return dict(zip(state.name, state.position))

    def joints_at(self, wanted, tolerance=0.002):
        """Waits until the joints are there."""

        def there(state):
            found = dict(zip(state.name, state.position))
            return all(abs(found[name] - angle) < tolerance for name, angle in wanted.items())

        return first(self.joint_states, there)

    def tool(self, transforms=None):
        """Where the frame `tool` is in the frame `base`, in metres, from the transforms alone."""
        if transforms is None:
            drop(self.tf)
            transforms = first(self.tf).transforms
        frames = {it.child_frame_id: it for it in transforms}
        point, link = (0.0, 0.0, 0.0), f"{self.namespace.strip('/')}/tool".lstrip("/")
        while link in frames:
            it = frames[link]
            at = it.transform.translation
            turned = rotated(it.transform.rotation, point)
            point = (turned[0] + at.x, turned[1] + at.y, turned[2] + at.z)
            link = it.header.frame_id
        assert link.endswith("base"), link
        return point

    def tool_at(self, wanted, tolerance=0.001):
        """Waits until the tool is there."""
        first(self.tf, lambda it: math.dist(self.tool(it.transforms), wanted) < tolerance)

    def go(self, x, y, z, turn=m.Quaternion()):
        pose = m.Pose(m.Vector3(x, y, z), turn)
        self.target.write(m.PoseStamped(m.Header(frame_id="base"), pose))

    def reported(self, text):
        """Waits until something is said in the log."""
        return first(self.rosout, lambda it: text in it.msg).msg

    def diagnosed(self, name, level=None, says=""):
        """Waits until a diagnosis is so."""
        found = []

        def is_so(array):
            for it in array.status:
                if it.name == f"dobot: {name}" and level in (None, it.level) and says in it.message:
                    found.append(it)
            return bool(found)

        first(self.diagnostics, is_so)
        return found[0]

    def follow(self, names, points, **more):
        """Sends a goal; each point is its angles in radians and its time in seconds."""
        trajectory = m.JointTrajectory(
            joint_names=names,
            points=[m.JointTrajectoryPoint(positions=list(at), time_from_start=m.Duration.of(s)) for at, s in points],
        )
        goal = uuid.uuid4().bytes
        accepted = self.send_goal(goal_id=goal, goal=m.FollowGoal(trajectory=trajectory, **more))
        assert accepted.accepted
        return goal

    def turn_gripper(self, *angles, **more):
        """Turns the gripper to angles in radians, and returns the result."""
        goal = uuid.uuid4().bytes
        command = m.JointState(m.Header(), ["gripper"], list(angles), [], more.get("effort", []))
        assert self.send_gripper(goal_id=goal, command=command).accepted
        return self.gripper_result(goal_id=goal)

    def result(self, goal):
        return self.get_result(goal_id=goal)


class Service:
    """A client of a service, as rmw_cyclonedds makes one."""

    def __init__(self, robot, name, request, response):
        self.request, self.number = request, 0
        self.guid = int.from_bytes(uuid.uuid4().bytes[:8], "little")
        self.asks = robot.writer(f"rq{name}Request", request)
        self.answers = robot.reader(f"rr{name}Reply", response)

    def __call__(self, **fields):
        until_match(self.asks, self.answers)
        self.number += 1
        self.asks.write(self.request(self.guid, self.number, **fields))
        return first(self.answers, lambda it: (it.guid, it.number) == (self.guid, self.number))


def first(reader, wanted=lambda it: True, within_s=PATIENCE_S):
    """The first message that is wanted; an error where none comes."""
    until, last = time.monotonic() + within_s, None
    new = ReadCondition(reader, ViewState.Any | InstanceState.Any | SampleState.NotRead)
    come = WaitSet(reader.participant)
    come.attach(new)
    while time.monotonic() < until:
        for last in reader.take():
            # What a writer that is gone leaves behind is no message.
            if last.sample_info.valid_data and wanted(last):
                return last
        come.wait(duration(seconds=0.5))
    raise AssertionError(f"nothing wanted came on {reader.topic.name} within {within_s} s; the last was {last}")


def drop(reader):
    """What came before does not count."""
    while reader.take(N=1000):
        pass


def until_match(writer, reader, within_s=PATIENCE_S):
    """Waits until both have found each other's other end."""
    until = time.monotonic() + within_s
    writer.set_status_mask(DDSStatus.PublicationMatched)
    reader.set_status_mask(DDSStatus.SubscriptionMatched)
    matched = WaitSet(reader.participant)
    matched.attach(writer)
    matched.attach(reader)
    while not (writer.get_matched_subscriptions() and reader.get_matched_publications()):
        assert time.monotonic() < until, f"nobody serves {writer.topic.name}"
        matched.wait(duration(seconds=0.5))


def rotated(turn, point):
    """A point turned by a unit quaternion."""
    axis = (turn.x, turn.y, turn.z)
    double = [2 * it for it in cross(axis, point)]
    more = cross(axis, double)
    return tuple(p + turn.w * d + c for p, d, c in zip(point, double, more))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
