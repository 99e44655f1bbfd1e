"""Moves an arm by a hand: ``python -m dobot_arm.hands`` (``pip install dobot-arm[hands]``).

Hold an open hand in front of the camera for half a second: the arm then follows it to the left, right, up and down. Pinch thumb
and finger to close. Push the flat hand forward to stop. Take the hand away, and nothing more is sent.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack
from math import inf

from .arm import Arm
from .errors import Error, Refused
from .hand import LEAST_SCORE, LOST_MS, Hand, Movement, Picture, SeenHand
from .senses import add_arm_options, connect_both, release, stop
from .status import Pose

_SEND_MS = 100.0
"""The least time between two positions that are sent."""
_WIDTH = 320
"""The width of the pictures that are looked at, in pixels."""
_TEXTS = {
    "none": "no hand",
    "several": "two hands: nothing is sent",
    "unsure": "the hand is not clear: nothing is sent",
    "other": "open your hand",
    "opening": "hold it",
    "controls": "the arm follows your hand",
    "stop": "the flat hand was pushed forward",
}
_KEEPS_CONTROL = ("controls", "none", "unsure")
"""A hand may be lost for a moment."""


class Follower:
    """Sends the arm where a hand goes: one position after the other, at most ten per second."""

    def __init__(self, arm: Arm, shown: Arm) -> None:
        """``arm`` moves, and ``shown`` stops meanwhile; they may be the same."""
        self._arm, self._shown = arm, shown
        self._hand = Hand()
        self._state = ""
        self._begin: Pose | None = None
        self._sent_ms = self._controlled_ms = -inf
        self._mover = ThreadPoolExecutor(1)
        self._motion: Future[None] | None = None

    def look(self, picture: Picture) -> None:
        """Takes the next picture."""
        self._check_motion()
        meaning = self._hand.look(picture)
        if meaning.state != self._state:
            self._state = meaning.state
            print(_TEXTS[meaning.state], flush=True)
        if meaning.state == "stop":
            stop(self._shown, "a flat hand was pushed forward")
        if meaning.movement is not None:
            self._controlled_ms = picture.at_ms
            self._follow(picture.at_ms, meaning.movement)
        elif meaning.state not in _KEEPS_CONTROL or picture.at_ms - self._controlled_ms > LOST_MS:
            self._lose()

    def wait(self) -> None:
        """Waits until the arm is where it was sent."""
        if self._motion is not None:
            self._motion.exception()

    def finish(self) -> None:
        """Sends nothing more, and waits for the last motion."""
        self._lose()
        self._mover.shutdown()

    def _follow(self, at_ms: float, movement: Movement) -> None:
        if self._begin is None:
            # Only the picture in which a hand takes control has no movement.
            if movement.left_mm or movement.up_mm:
                return
            self._begin = self._arm.pose
        is_moving = self._motion is not None and not self._motion.done()
        if is_moving or at_ms - self._sent_ms < _SEND_MS:
            return
        self._sent_ms = at_ms
        self._motion = self._mover.submit(self._move, self._begin, movement)

    def _move(self, begin: Pose, movement: Movement) -> None:
        y_mm, z_mm = begin.y_mm + movement.left_mm, begin.z_mm + movement.up_mm
        self._arm.hand(begin.x_mm, y_mm, z_mm, grab=movement.closed, seen=True)

    def _check_motion(self) -> None:
        """After a position that was refused the hand has to be opened again."""
        if self._motion is None or not self._motion.done():
            return
        error, self._motion = self._motion.exception(), None
        # A stock arm would hang on a position that moves nothing, so it is refused: the hand is at rest.
        if error is None or (isinstance(error, Refused) and error.kind == "command"):
            return
        self._lose()
        self._hand = Hand()
        if not isinstance(error, Error):
            raise error
        print(error, flush=True)

    def _lose(self) -> None:
        """Others may move the arm between two hands."""
        if self._begin is not None:
            self._mover.submit(release, self._arm)
        self._begin = None


def _pictures(camera: int, video: str | None) -> Iterator[Picture]:
    """The hands that a camera or a video shows."""
    try:
        import cv2
        import mediapipe  # type: ignore[import-not-found,import-untyped,unused-ignore]
    except ImportError as missing:
        raise Error("hands need mediapipe: pip install dobot-arm[hands]") from missing
    source = cv2.VideoCapture(camera) if video is None else cv2.VideoCapture(video)
    name = f"camera {camera}" if video is None else video
    if not source.isOpened():
        raise Error(f"{name} cannot be opened; check its cable, and that no other program uses it" if video is None else f"{name} is no video")
    # Two, so that a second hand is noticed.
    finder = mediapipe.solutions.hands.Hands(
        max_num_hands=2, model_complexity=0, min_detection_confidence=LEAST_SCORE, min_tracking_confidence=LEAST_SCORE
    )
    with finder:
        while True:
            is_there, frame = source.read()
            if not is_there:
                if video is None:
                    raise Error(f"{name} gives no picture; check its cable")
                return
            at_ms = time.monotonic() * 1000 if video is None else float(source.get(cv2.CAP_PROP_POS_MSEC))
            high, wide = frame.shape[:2]
            small = cv2.resize(frame, (_WIDTH, round(_WIDTH * high / wide)))
            found = finder.process(cv2.cvtColor(small, cv2.COLOR_BGR2RGB))
            hands = zip(found.multi_hand_landmarks or (), found.multi_handedness or ())
            yield Picture(at_ms, [_seen(landmarks, handedness) for landmarks, handedness in hands], wide / high)


def _seen(landmarks: object, handedness: object) -> SeenHand:
    points = [(point.x, point.y) for point in landmarks.landmark]  # type: ignore[attr-defined]
    return SeenHand(handedness.classification[0].score, points)  # type: ignore[attr-defined]


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m dobot_arm.hands", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arm_options(parser)
    source = parser.add_mutually_exclusive_group()
    source.add_argument("--camera", type=int, default=0, metavar="NUMBER", help="the camera to use (default: 0)")
    source.add_argument("--video", metavar="FILE", help="look at a video instead of a camera")
    return parser.parse_args()


def _run(arguments: argparse.Namespace) -> None:
    with ExitStack() as until_end:
        arm, shown = connect_both(arguments, "hand", "hand camera", until_end)
        follower = Follower(arm, shown)
        until_end.callback(follower.finish)
        for picture in _pictures(arguments.camera, arguments.video):
            follower.look(picture)


def main() -> int:
    """Follows a hand until Ctrl-C or the end of the video; returns the exit code."""
    try:
        _run(_arguments())
    except KeyboardInterrupt:
        pass
    except (Error, OSError) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
