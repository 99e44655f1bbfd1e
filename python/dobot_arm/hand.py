"""What a hand in front of the camera means: an open hand takes control, its movement is the arm's, a pinch closes, a push stops.

Pure: pictures in, what to do out, by the rules of the page. Whenever it is not sure, nothing is sent.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot, inf, isfinite
from typing import Literal

Landmark = Sequence[float]
"""A point of a hand: x and y as shares of the picture's width and height, from its upper left corner."""
HandState = Literal["none", "several", "unsure", "other", "opening", "controls", "stop"]
"""``other``: one hand, not open. ``opening``: an open hand that has not been held long enough."""

OPEN_MS = 500.0
"""How long an open hand is held until it takes control."""
LOST_MS = 300.0
"""How long a hand may be lost until it has to be opened again; nothing is sent meanwhile."""
LEAST_SCORE = 0.7
"""The least certainty, 0 to 1."""
_MM_PER_WIDTH = 300.0
"""How far the arm goes for a movement by the width of the picture."""
_PINCHED, _RELEASED = 0.3, 0.5
"""A pinch begins and ends when thumb and finger are this far apart, in palms."""
_PUSHED, _PUSH_MS = 1.4, 600.0
"""A flat hand that grows by this factor within this time is pushed forward."""
_JUMP = 1.5
"""A hand that jumps farther between two pictures is another one, in palms."""

_POINTS, _WRIST, _THUMB, _INDEX, _MIDDLE_KNUCKLE = 21, 0, 4, 8, 9
_PALM = (0, 5, 9, 13, 17)
_FINGERS = ((8, 6), (12, 10), (16, 14), (20, 18))
"""The tips of the fingers and the joints below them."""


@dataclass(frozen=True)
class SeenHand:
    """A hand in a picture."""

    score: float
    """The certainty, 0 to 1."""
    points: Sequence[Landmark]
    """The 21 points of MediaPipe, from the wrist to the tip of the little finger."""

    @property
    def is_clear(self) -> bool:
        """Whether the hand is complete, its points are numbers, and it is certain enough."""
        numbers = [self.score, *(number for point in self.points for number in point[:2])]
        return len(self.points) == _POINTS and all(map(isfinite, numbers)) and self.score >= LEAST_SCORE


@dataclass(frozen=True)
class Picture:
    """The hands in a picture."""

    at_ms: float
    hands: Sequence[SeenHand]
    aspect: float
    """Width by height."""


@dataclass(frozen=True)
class Movement:
    """The movement since the hand took control."""

    left_mm: float
    up_mm: float
    closed: bool
    """Whether the hand is pinched."""


@dataclass(frozen=True)
class Meaning:
    """What a picture means."""

    state: HandState
    movement: Movement | None = None
    """What to send, or None for nothing."""


@dataclass(frozen=True)
class _Measures:
    palm: float
    """The length of the palm, in widths of the picture."""
    middle: tuple[float, float]
    """The middle of the palm, in widths of the picture, y down."""
    is_open: bool
    pinch: float
    """The distance between thumb and finger, in palms."""


class Hand:
    """Follows a hand from picture to picture."""

    def __init__(self) -> None:
        self._seen_ms = -inf
        self._opened_ms: float | None = None
        self._origin: tuple[float, float] | None = None
        self._last: tuple[float, float] | None = None
        self._palms: list[tuple[float, float]] = []
        self._closed = False

    def look(self, picture: Picture) -> Meaning:
        """Takes the next picture."""
        at_ms = picture.at_ms
        if at_ms - self._seen_ms > LOST_MS:
            self._lose()
        if len(picture.hands) > 1:
            self._lose()
            return Meaning("several")
        if not picture.hands or not picture.hands[0].is_clear:
            self._opened_ms = None
            return Meaning("unsure" if picture.hands else "none")
        hand = _measure(picture.hands[0], picture.aspect)
        if self._last and _apart(self._last, hand.middle) > _JUMP * hand.palm:
            self._lose()
        self._seen_ms, self._last = at_ms, hand.middle
        is_flat = hand.is_open and hand.pinch > _RELEASED
        if self._is_pushed(at_ms, hand.palm, is_flat):
            self._lose()
            return Meaning("stop")
        if self._origin is None:
            return self._take_control(at_ms, hand.middle, is_flat)
        self._closed = hand.pinch < (_RELEASED if self._closed else _PINCHED)
        (x, y), (from_x, from_y) = hand.middle, self._origin
        # A camera that faces a person sees the person's left on its right.
        return Meaning("controls", Movement((x - from_x) * _MM_PER_WIDTH, (from_y - y) * _MM_PER_WIDTH, self._closed))

    def _lose(self) -> None:
        self._opened_ms = self._origin = self._last = None
        self._palms, self._closed = [], False

    def _is_pushed(self, at_ms: float, palm: float, is_flat: bool) -> bool:
        recent = [one for one in self._palms if at_ms - one[0] <= _PUSH_MS]
        self._palms = [*recent, (at_ms, palm)] if is_flat else []
        return is_flat and palm > _PUSHED * min(palm for _, palm in self._palms)

    def _take_control(self, at_ms: float, middle: tuple[float, float], is_flat: bool) -> Meaning:
        if not is_flat:
            self._opened_ms = None
            return Meaning("other")
        if self._opened_ms is None:
            self._opened_ms = at_ms
        if at_ms - self._opened_ms < OPEN_MS:
            return Meaning("opening")
        self._origin = middle
        return Meaning("controls", Movement(0.0, 0.0, False))


def _measure(hand: SeenHand, aspect: float) -> _Measures:
    at = [(point[0], point[1] / aspect) for point in hand.points]
    palm = _apart(at[_WRIST], at[_MIDDLE_KNUCKLE])
    x, y = zip(*(at[number] for number in _PALM))
    is_open = all(_apart(at[tip], at[_WRIST]) > 1.15 * _apart(at[joint], at[_WRIST]) for tip, joint in _FINGERS)
    thumb = _apart(at[_THUMB], at[_INDEX])
    return _Measures(palm, (sum(x) / len(_PALM), sum(y) / len(_PALM)), is_open, thumb / palm if palm > 0 else inf)


def _apart(a: tuple[float, float], b: tuple[float, float]) -> float:
    return hypot(a[0] - b[0], a[1] - b[1])
