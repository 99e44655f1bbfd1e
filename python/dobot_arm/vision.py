"""A camera that sees the calibration sheet and what lies on it: ``pip install dobot-arm[vision]``.

The four markers of the sheet are where the arm's calibrated frame has them, so a place in a picture is a place for the
arm. The functions are those of the page (``page/files/vision``), tested with the same photos.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal, TypeAlias, cast

import numpy as np

from ._core import sheet_markers
from .errors import Error
from .programs import SeenPosition

try:
    import cv2
except ImportError as _missing:  # pragma: no cover
    raise ImportError("dobot_arm.Eye needs OpenCV: pip install dobot-arm[vision]") from _missing

if TYPE_CHECKING:
    from .arm import Arm
    from .calibration import Calibration
    from .programs import Ask, Question
    from .status import Status

    # Arrays of numpy, of numbers and of a picture's bytes. Their types are those of an optional package.
    Array: TypeAlias = Any
    Frame: TypeAlias = Any

Trouble = Literal["few_corners", "blurred", "glare"]
"""What is wrong with a picture: fewer than three markers of the sheet, blur, or overexposed parts."""

SHEET_MARKERS = tuple(np.array(corners) for corners in sheet_markers())
"""The corners of the markers 0 to 3 of the sheet, clockwise from the upper left one, in mm."""
LEAST_MARKERS = 3
"""The fewest markers of the sheet that determine where it is."""

_MIDDLE_MM = np.array([200.0, 0.0])
_UNIT_MM = 100.0
_LENS, _LENS_DEVIATION, _CORNER_PX = 0.4, 0.2, 0.3
_USUAL_FOCAL, _FOCAL = 0.95, (0.5, 2.5)
_SHARP, _OVEREXPOSED = 0.33, 0.02
_HUE_DEG, _STRONG, _LIGHT, _LEAST_BLOB = 20.0, 0.45, 0.2, 0.0015


@dataclass(frozen=True)
class Place:
    """Where an object was seen, in the arm's frame."""

    x_mm: float
    """Ahead of the base's axis, in mm."""
    y_mm: float
    """To the left of the base's axis, in mm."""
    turn_deg: float
    """How its marker is turned, counter-clockwise from above, in degrees, -180 to 180."""
    seen_at: float
    """When it was seen, by :func:`time.time`, in seconds."""


@dataclass(frozen=True)
class Seen:
    """What a picture shows."""

    places: Mapping[int, Place]
    """The objects with markers, by number."""
    troubles: tuple[Trouble, ...]
    """What is wrong with the picture. With ``few_corners`` there are no places."""
    typical_mm: float
    """The typical deviation of a marker's corner from where the sheet has it, in mm; nan without places."""
    blob: Place | None
    """The largest blob of the hue that was asked for."""


@dataclass(frozen=True)
class _View:
    """How the camera sees the sheet."""

    size: tuple[int, int]
    lens: float
    to_pixels: Array
    to_sheet: Array
    camera_mm: Array
    typical_mm: float

    def on_sheet(self, pixels: Array, height_mm: float = 0.0) -> Array:
        """The places of pixels at a height above the sheet, in mm."""
        at = _project(self.to_sheet, _straight(self.size, self.lens, pixels)) * _UNIT_MM + _MIDDLE_MM
        return cast("Array", at + (self.camera_mm[:2] - at) * (height_mm / self.camera_mm[2]))

    def in_picture(self, places_mm: Array) -> Array:
        """The pixels of places on the sheet."""
        at = _project(self.to_pixels, (places_mm - _MIDDLE_MM) / _UNIT_MM)
        return _bent(self.size, self.lens, at)


class Eye:
    """A camera above the sheet, or pictures from elsewhere.

    ``heights`` are the heights of the objects' markers above the sheet in mm, by number; unlisted ones lie on it. A
    marker 25 mm high that is seen at 30 degrees seems 14 mm away from where it is.
    """

    def __init__(self, camera: int | str | None = 0, *, heights: Mapping[int, float] | None = None) -> None:
        self.heights: dict[int, float] = dict(heights or {})
        self._detector = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50))
        self._camera = None if camera is None else cv2.VideoCapture(camera)
        if self._camera is not None and not self._camera.isOpened():
            raise Error(f"camera {camera!r} cannot be opened; check its cable, and that no other program uses it")

    def __enter__(self) -> Eye:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """Gives the camera back."""
        if self._camera is not None:
            self._camera.release()

    def frame(self) -> Frame:
        """The current picture of the camera: blue, green, red."""
        if self._camera is None:
            raise Error("this Eye has no camera; give look() a frame")
        there, frame = self._camera.read()
        if not there:
            raise Error("the camera gives no picture; check its cable")
        return cast("Frame", frame)

    def look(self, frame: Frame | None = None, *, hue_deg: float | None = None) -> Seen:
        """What a picture shows: the camera's, or ``frame`` (blue, green, red, as of ``cv2.imread``).

        ``hue_deg`` also finds the largest blob of that hue (0 red, 60 yellow, 120 green, 240 blue) between the markers
        of the sheet.
        """
        frame = self.frame() if frame is None else frame
        seen_at = time.time()
        light = _brightness(frame)
        found = self._markers(light)
        troubles = _troubles(frame, light)
        view = _view(found, (light.shape[1], light.shape[0]))
        if view is None:
            return Seen({}, ("few_corners", *troubles), float("nan"), None)
        places = {
            number: _place(view.on_sheet(corners, self.heights.get(number, 0.0)), seen_at)
            for number, corners in found.items()
            if number >= len(SHEET_MARKERS)
        }
        blob = None if hue_deg is None else _blob(frame, view, hue_deg, seen_at)
        return Seen(places, troubles, view.typical_mm, blob)

    def ask(self, *, z_mm: float, timeout: float = 2.0) -> Ask:
        """A function for ``arm.run(program, ask=...)`` that answers where a marker is (``go = { from = "seen", marker = 7 }``).

        ``z_mm`` is the height of the tool on the sheet; the height of the object is added. Raises :class:`Error` if the
        marker is not seen for ``timeout`` seconds.
        """

        def answer(question: Question) -> Sequence[float]:
            name = question.place or ""
            number = name.removeprefix("marker ")
            if not name.startswith("marker ") or not number.isdigit():
                raise Error(f"the program asks {question.text!r}; an Eye answers only where a marker is")
            until = time.monotonic() + timeout
            while (place := self.look().places.get(int(number))) is None:
                if time.monotonic() > until:
                    raise Error(f"marker {number} was not seen for {timeout} s; check that it and three corners of the sheet are in the picture")
            return SeenPosition(place.x_mm, place.y_mm, z_mm + self.heights.get(int(number), 0.0), place.turn_deg)

        return answer

    def crosses(self, frame: Frame, wanted: Sequence[tuple[float, float]], *, within_mm: float = 14.0) -> list[tuple[float, float] | None]:
        """Where crosses lie that an arm drew, each near a wanted position, in mm; None where there is none.

        Draw them with lines of 8 mm at 45 degrees, at least 10 mm from the points of the sheet. The photo should have
        at least 1200 pixels along its longer side.
        """
        light = _brightness(frame)
        view = _view(self._markers(light), (light.shape[1], light.shape[0]))
        if view is None:
            raise Error("fewer than three markers of the sheet are in the photo; take another one with all four corners")
        return [_cross(light, view, np.array(place), within_mm) for place in wanted]

    def _markers(self, light: Frame) -> dict[int, Array]:
        corners, numbers, _ = self._detector.detectMarkers(light)
        if numbers is None:
            return {}
        # OpenCV counts from the middle of the first pixel.
        rough = [np.asarray(own, float).reshape(4, 2) + 0.5 for own in corners]
        return {int(number): _exact_corners(light, own) for number, own in zip(numbers.ravel(), rough)}


def _brightness(frame: Frame) -> Frame:
    return cast("Frame", cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY))


_NEAR_PX, _PLACES, _ENDS = 3, 16, 0.12


def _exact_corners(light: Frame, rough: Array) -> Array:
    """The exact corners of a marker: where lines through its edges meet."""
    lines = [_edge(light, rough[n], rough[(n + 1) % 4]) for n in range(4)]
    exact = rough.copy()
    for n in range(4):
        before, after = lines[n - 1], lines[n]
        if before is None or after is None:
            continue
        (p, a), (q, b) = before, after
        sine = a[0] * b[1] - a[1] * b[0]
        if abs(sine) < 0.1:
            continue
        met = p + a * ((q[0] - p[0]) * b[1] - (q[1] - p[1]) * b[0]) / sine
        if np.linalg.norm(met - rough[n]) < 2 * _NEAR_PX:
            exact[n] = met
    return exact


def _edge(light: Frame, start: Array, end: Array) -> tuple[Array, Array] | None:
    """The line along an edge: a point and its direction. The marker is black, and its corners go clockwise."""
    along = (end - start) / np.linalg.norm(end - start)
    out = np.array([along[1], -along[0]])
    parts = np.linspace(_ENDS, 1 - _ENDS, _PLACES)
    away = np.arange(-_NEAR_PX - 0.5, _NEAR_PX + 0.75, 0.5)
    at = (start + parts[:, None] * (end - start))[:, None] + away[None, :, None] * out - 0.5
    seen = cv2.remap(light, at[..., 0].astype(np.float32), at[..., 1].astype(np.float32), cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE).astype(float)
    # From half a pixel before each place to half a pixel after it.
    slopes = np.maximum(0, seen[:, 2:] - seen[:, :-2])
    near = np.abs(np.arange(slopes.shape[1]) - slopes.argmax(axis=1)[:, None]) <= 3
    slopes = slopes * near
    sums = slopes.sum(axis=1)
    kept = sums >= 20
    if kept.sum() < _PLACES / 2:
        return None
    middle = (slopes @ away[1:-1])[kept] / sums[kept]
    points = (start + parts[:, None] * (end - start))[kept] + middle[:, None] * out
    return _line(points)


def _line(points: Array) -> tuple[Array, Array]:
    """The line through points, without those that are far off it."""
    middle = points.mean(axis=0)
    (xx, xy), (_, yy) = (points - middle).T @ (points - middle)
    turn = np.arctan2(2 * xy, xx - yy) / 2
    along = np.array([np.cos(turn), np.sin(turn)])
    off = np.abs((points - middle) @ np.array([along[1], -along[0]]))
    kept = points[off < 0.6]
    return _line(kept) if _PLACES / 2 <= len(kept) < len(points) else (middle, along)


def _straight(size: tuple[int, int], lens: float, pixels: Array) -> Array:
    wide, high = size
    at = (pixels - np.array([wide / 2, high / 2])) / wide
    return cast("Array", at * (1 + lens * np.sum(at**2, axis=-1, keepdims=True)))


def _bent(size: tuple[int, int], lens: float, at: Array) -> Array:
    wide, high = size
    squared = np.sum(at**2, axis=-1, keepdims=True)
    stretch = np.ones_like(squared)
    for _ in range(8):
        stretch = 1 + lens * squared / stretch**2
    return cast("Array", at / stretch * wide + np.array([wide / 2, high / 2]))


def _project(h: Array, at: Array) -> Array:
    w = at @ h[2, :2] + h[2, 2]
    return cast("Array", (at @ h[:2, :2].T + h[:2, 2]) / w[..., None])


def _homography(sheet: Array, picture: Array) -> Array | None:
    """The homography that maps points to others, by least squares; None if they are in a line."""
    h: Array | None = None
    for _ in range(3):
        w = np.ones(len(sheet)) if h is None else sheet @ h[2, :2] + 1
        (x, y), (u, v) = sheet.T, picture.T
        zero, one = np.zeros_like(x), np.ones_like(x)
        rows = np.stack([np.stack([x, y, one, zero, zero, zero, -u * x, -u * y], 1), np.stack([zero, zero, zero, x, y, one, -v * x, -v * y], 1)]) / w[None, :, None]
        right = np.stack([u, v]) / w
        try:
            found = np.linalg.solve(np.einsum("knm,knl->ml", rows, rows), np.einsum("knm,kn->m", rows, right))
        except np.linalg.LinAlgError:
            return None
        h = np.append(found, 1).reshape(3, 3)
    return h


def _view(found: Mapping[int, Array], size: tuple[int, int]) -> _View | None:
    """How the camera sees the sheet; None with fewer than three of its markers."""
    numbers = [number for number in found if number < len(SHEET_MARKERS)]
    if len(numbers) < LEAST_MARKERS:
        return None
    sheet = (np.concatenate([SHEET_MARKERS[number] for number in numbers]) - _MIDDLE_MM) / _UNIT_MM
    pixels = np.concatenate([found[number] for number in numbers])

    def fit(lens: float) -> tuple[Array, float, float] | None:
        picture = _straight(size, lens, pixels)
        h = _homography(sheet, picture)
        if h is None:
            return None
        off = float(np.sum((_project(h, sheet) - picture) ** 2))
        return h, off, off * size[0] ** 2 / _CORNER_PX**2 + (lens / _LENS_DEVIATION) ** 2

    lens = _least(lambda lens: float("inf") if (fitted := fit(lens)) is None else fitted[2], -_LENS, _LENS)
    fitted = fit(lens)
    if fitted is None:
        return None
    h, off, _ = fitted
    camera_mm = _camera(h) * _UNIT_MM + np.append(_MIDDLE_MM, 0.0)
    left, right = _project(h, np.array([[-0.5, 0.0], [0.5, 0.0]]))
    typical_mm = float(np.sqrt(off / len(sheet)) / np.linalg.norm(right - left) * _UNIT_MM)
    return _View(size, lens, h, cast("Array", np.linalg.inv(h)), camera_mm, typical_mm)


def _camera(h: Array) -> Array:
    """Where the camera is, in units from the middle of the sheet."""
    (a, b, c), (d, e, f), (g, i, j) = h
    p1, q1, p2, q2 = a * b + d * e, g * i, a * a + d * d - b * b - e * e, g * g - i * i
    with np.errstate(all="ignore"):
        shown = float(np.sqrt(-(p1 * p1 + p2 * p2) / (p1 * q1 + p2 * q2)))
    focal = shown if _FOCAL[0] <= shown <= _FOCAL[1] else _USUAL_FOCAL
    r1, r2, t = np.array([a / focal, d / focal, g]), np.array([b / focal, e / focal, i]), np.array([c / focal, f / focal, j])
    scale = 2 / (np.linalg.norm(r1) + np.linalg.norm(r2))
    r3 = np.cross(r1, r2) * scale
    along = -scale * scale * np.array([r1 @ t, r2 @ t, r3 @ t])
    return np.append(along[:2], abs(along[2]))


def _least(f: Any, low: float, high: float) -> float:
    """Where a function of one number is least (golden section)."""
    part = (5**0.5 - 1) / 2
    a, b = high - part * (high - low), low + part * (high - low)
    fa, fb = f(a), f(b)
    for _ in range(22):
        if fa < fb:
            high, b, fb = b, a, fa
            a = high - part * (high - low)
            fa = f(a)
        else:
            low, a, fa = a, b, fb
            b = low + part * (high - low)
            fb = f(b)
    return (low + high) / 2


def _place(corners_mm: Array, seen_at: float) -> Place:
    x, y = corners_mm.mean(axis=0)
    ahead = corners_mm[0] + corners_mm[1] - corners_mm[2] - corners_mm[3]
    return Place(float(x), float(y), float(np.degrees(np.arctan2(ahead[1], ahead[0]))), seen_at)


def _troubles(frame: Frame, light: Frame) -> tuple[Trouble, ...]:
    slopes = np.abs(light[:, 2:].astype(int) - light[:, :-2])
    range_of = np.percentile(light, 99) - np.percentile(light, 1)
    sharpness = np.percentile(slopes, 99.8) / max(float(range_of), 30)
    troubles: list[Trouble] = []
    if sharpness < _SHARP:
        troubles.append("blurred")
    if np.mean(np.all(frame > 252, axis=2)) > _OVEREXPOSED:
        troubles.append("glare")
    return tuple(troubles)


def _blob(frame: Frame, view: _View, hue_deg: float, seen_at: float) -> Place | None:
    """The largest blob of a hue on the sheet, between its markers."""
    colours = cv2.cvtColor(frame.astype(np.float32) / 255, cv2.COLOR_BGR2HSV)
    off = np.abs((colours[..., 0] - hue_deg + 540) % 360 - 180)
    fits = (off <= _HUE_DEG) & (colours[..., 1] >= _STRONG) & (colours[..., 2] >= _LIGHT)
    corners = np.concatenate([np.asarray(marker) for marker in SHEET_MARKERS])
    (x0, y0), (x1, y1) = corners.min(axis=0), corners.max(axis=0)
    edge = view.in_picture(np.array([[x0, y0], [x0, y1], [x1, y1], [x1, y0]]))
    inside = cv2.fillConvexPoly(np.zeros(fits.shape, np.uint8), edge.round().astype(np.int32), 1)
    count, _, stats, middles = cv2.connectedComponentsWithStats((fits & (inside > 0)).astype(np.uint8), connectivity=4)
    if count < 2:
        return None
    best = 1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))
    if stats[best, cv2.CC_STAT_AREA] < _LEAST_BLOB * inside.sum():
        return None
    x, y = view.on_sheet(np.asarray(middles[best], float)[None] + 0.5)[0]
    return Place(float(x), float(y), 0.0, seen_at)


CROSSES = tuple((140.0 + 30.0 * row, -90.0 + 45.0 * column) for row in range(5) for column in range(5))
"""Where an arm draws crosses for a photo, in mm: between the points of the sheet."""


@dataclass(frozen=True)
class Cross:
    """A cross that an arm drew."""

    wanted: tuple[float, float]
    """Where it was to be, in mm."""
    status: Status
    """What the arm reported at its middle."""


def draw_crosses(arm: Arm, z_mm: float | Callable[[float, float], float], *, lift_mm: float = 15.0, speed: float = 30.0) -> list[Cross]:
    """Draws 25 crosses on the sheet, for :func:`calibrate_from_photo`. Mount the pen, and use no calibration.

    ``z_mm`` is where the pen touches the paper: a number, or a function of x and y for paper that is not level for an arm
    without calibration. They must land within 14 mm of :data:`CROSSES`; touch four points of the sheet first if they do not.
    """
    height = z_mm if callable(z_mm) else lambda x, y: z_mm
    drawn = []
    arm.speed(speed, speed)
    for x, y in CROSSES:
        z = height(x, y)
        arm.move_to(x, y, z + lift_mm, path="movj")
        arm.move_to(x, y, z, path="movl")
        drawn.append(Cross((x, y), arm.next_status()))
        for dx, dy in (_DIAGONAL, -_DIAGONAL), (_DIAGONAL, _DIAGONAL):
            for way in (1, -1, 0):
                arm.move_to(x + way * dx, y + way * dy, height(x + way * dx, y + way * dy), path="movl")
        arm.move_to(x, y, z + lift_mm, path="movl")
    return drawn


def calibrate_from_photo(drawn: Sequence[Cross], photo: Frame, *, tool_measured: bool = False) -> Calibration:
    """Fits a calibration to crosses that an arm drew, and a photo of the sheet with its four corners.

    Raises :class:`Error` if fewer than 12 of the crosses are found, and :class:`ValueError` as :func:`calibrate`.
    """
    from .calibration import Touch, calibrate

    found = Eye(None).crosses(photo, [cross.wanted for cross in drawn])
    touches = [Touch(*place, cross.status) for place, cross in zip(found, drawn) if place is not None]
    if len(touches) < _LEAST_CROSSES:
        raise Error(f"{len(touches)} of {len(drawn)} crosses were found in the photo; at least {_LEAST_CROSSES} are needed: take a sharp photo from above, without shadows")
    return calibrate(touches, tool_measured=tool_measured)


_LEAST_CROSSES = 12
_DIAGONAL = 4 / 2**0.5
"""How far a line of a cross reaches, along x and y: lines of 8 mm at 45 degrees."""
_STEP_MM = 0.1
"""The grid on which the surroundings of a cross are seen from above."""
_ARM_MM = 3.6
"""How far from its middle a cross is dark, less than half of its lines."""


def _cross(light: Frame, view: _View, wanted: Array, within_mm: float) -> tuple[float, float] | None:
    """The cross near a position: the best match, and then where lines through its darkest places meet."""
    reach = within_mm + _ARM_MM
    steps = np.arange(-reach, reach + _STEP_MM / 2, _STEP_MM)
    # Rows go along the first line of the cross, columns along the second one: both are at 45 degrees.
    along, across = np.meshgrid(steps, steps, indexing="ij")
    places = wanted + np.stack([along + across, along - across], -1) / np.sqrt(2)
    pixels = view.in_picture(places.reshape(-1, 2)).reshape(*along.shape, 2).astype(np.float32) - 0.5
    above = cv2.remap(light, pixels[..., 0], pixels[..., 1], cv2.INTER_CUBIC).astype(np.float64)
    dark = np.maximum(0, np.median(above) - above)
    half = round(_ARM_MM / _STEP_MM)
    size = 2 * half + 1
    pattern = np.zeros((size, size))
    pattern[half - 2 : half + 3, :] = 1
    pattern[:, half - 2 : half + 3] = 1
    match = cv2.matchTemplate(dark.astype(np.float32), pattern.astype(np.float32), cv2.TM_CCOEFF_NORMED)
    _, best, _, (column, row) = cv2.minMaxLoc(match)
    if best < 0.45:
        return None
    own = dark[row : row + size, column : column + size]
    # The profile of each line, without the middle where they cross; the mean of their darkness is exact to a hundredth of a mm.
    outside = np.abs(np.arange(size) - half) > round(1.0 / _STEP_MM)
    window = np.abs(np.arange(size) - half) <= round(1.0 / _STEP_MM)
    offsets = (np.arange(size) - half) * _STEP_MM
    first, second = own[:, outside].sum(axis=1) * window, own[outside, :].sum(axis=0) * window
    middle = [float(profile @ offsets / profile.sum()) for profile in (first, second)]
    a, b = steps[row + half] + middle[0], steps[column + half] + middle[1]
    x, y = wanted + np.array([a + b, a - b]) / np.sqrt(2)
    return float(x), float(y)
