"""The world of a virtual arm: paper, tool and objects."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from ._core import world_svg

Stroke = list[tuple[float, float]]
"""The path of a pen or a laser: x and y in the base frame, in mm. One point is a dot."""


@dataclass(frozen=True)
class Object:
    """An object on the table, or held by the tool."""

    name: str
    x_mm: float
    """The position of its centre: forward."""
    y_mm: float
    """The position of its centre: to the left."""
    bottom_mm: float
    """The height of its underside above the table."""
    turn_deg: float
    """Its rotation about the vertical, counter-clockwise."""
    size_mm: tuple[float, float, float]
    """Its sides along X, Y and Z before the rotation; for a cylinder twice the diameter, and the height."""
    mass_g: float
    color: str
    """Its colour, as ``#rrggbb``."""
    held: bool
    """Whether it moves with the tool."""


@dataclass(frozen=True)
class World:
    """The world of a virtual arm at one moment. Displays its picture in a notebook."""

    time_s: float
    """The arm's time since power-up, in seconds."""
    objects: dict[str, Object]
    """The objects, by name."""
    ink: list[Stroke]
    """The lines of the pen, in drawing order."""
    burns: list[Stroke]
    """The lines of the laser."""
    events: list[dict[str, Any]]
    """The last hundred events, the oldest first: ``at_s``, ``event`` and its details."""
    state: dict[str, Any]
    """The whole state, with the names of the API."""

    @classmethod
    def _of(cls, text: str) -> World:
        state = json.loads(text)
        objects = [_object(entry, entry["name"] in state["held"]) for entry in state["objects"]]
        return cls(
            time_s=state["time_s"],
            objects={item.name: item for item in objects},
            ink=_lines(state["strokes"]),
            burns=_lines(state["burns"]),
            events=state["events"],
            state=state,
        )

    def svg(self) -> str:
        """A picture from above and from the side (SVG)."""
        return world_svg(json.dumps(self.state))

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<World: {len(self.objects)} objects, {len(self.ink)} lines of ink>"


def _lines(marks: list[dict[str, Any]]) -> list[Stroke]:
    return [[(x, y) for x, y in mark["points_mm"]] for mark in marks]


def _object(entry: dict[str, Any], held: bool) -> Object:
    shape = entry["shape"]
    if shape["type"] == "box":
        size = tuple(shape["size_mm"])
    else:
        size = (shape["diameter_mm"], shape["diameter_mm"], shape["height_mm"])
    return Object(
        name=entry["name"], x_mm=entry["at_mm"][0], y_mm=entry["at_mm"][1], bottom_mm=entry["bottom_mm"],
        turn_deg=entry["turn_deg"], size_mm=size, mass_g=entry["mass_g"], color=entry["color"], held=held,
    )
