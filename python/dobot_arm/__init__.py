"""The original Dobot Arm (2016), with the safety rules of its station.

Points are millimetres in the base frame (x forward, y left, z up from the pivot of the rear arm), angles are
degrees.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._core import __version__
from .arm import Arm, Jog, connect
from .drawing import Plan, Progress, bar, formats, plan
from .errors import Closed, Error, Failed, Kind, LinkLost, Paused, Refused, Stopped, kinds
from .operations import Button, Path, Tool
from .programs import (
    Ask, Point, Program, ProgramProblem, ProgramReport, ProgramStep, Question, SeenPosition, Step, program, program_bar,
)
from .state import ControlState, JobState, LaserState, LinkState, State, StopState
from .status import Joints, Pose, Status
from .take import Take
from .world import Object, World

if TYPE_CHECKING:
    from .aio import AsyncArm, AsyncJog, aconnect
    from .calibration import SHEET, Calibration, Touch, calibrate
    from .recording import Recording, dataset, log
    from .served import Served, serve
    from .stored import Files, StoredFile, files
    from .simulation import Simulation, simulate
    from .table import Table
    from .testing import assert_ink, assert_object
    from .vision import Eye, Place, calibrate_from_photo, draw_crosses

__all__ = [
    "Arm", "Ask", "AsyncArm", "AsyncJog", "Button", "Calibration", "Closed", "ControlState", "Error", "Eye",
    "Failed", "Files", "JobState", "Jog", "Joints", "Kind", "LaserState", "LinkLost", "LinkState", "Object",
    "Path", "Paused", "Place", "Plan", "Point", "Pose", "Program", "ProgramProblem", "ProgramReport",
    "ProgramStep", "Progress", "Question", "Recording", "Refused", "SHEET", "SeenPosition", "Served", "Simulation", "State",
    "Status", "Step", "StopState", "Stopped", "StoredFile", "Table", "Take", "Tool", "Touch", "World",
    "__version__", "aconnect", "assert_ink", "assert_object", "bar", "calibrate", "calibrate_from_photo",
    "connect", "dataset", "draw_crosses", "files", "formats", "kinds", "log", "plan", "program", "program_bar", "serve",
    "simulate",
]

_LATER = {
    "AsyncArm": "aio",
    "AsyncJog": "aio",
    "aconnect": "aio",
    "Calibration": "calibration",
    "SHEET": "calibration",
    "Touch": "calibration",
    "calibrate": "calibration",
    "Recording": "recording",
    "dataset": "recording",
    "log": "recording",
    "Served": "served",
    "serve": "served",
    "Files": "stored",
    "StoredFile": "stored",
    "files": "stored",
    "Simulation": "simulation",
    "simulate": "simulation",
    "Table": "table",
    "Eye": "vision",
    "Place": "vision",
    "calibrate_from_photo": "vision",
    "draw_crosses": "vision",
    "assert_ink": "testing",
    "assert_object": "testing",
}
"""Names that are loaded on first use, since they are slow to import or rarely needed."""


def __getattr__(name: str) -> object:
    if name in _LATER:
        from importlib import import_module

        return getattr(import_module(f".{_LATER[name]}", __name__), name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
