"""What is around a virtual arm: paper, tool and objects."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any

from ._core import world_svg

Stroke = list[tuple[float, float]]
"""Where a pen or a laser went: x and y in the base frame, in mm. One point is a dot."""


@dataclass(frozen=True)
class Object:
    """A thing on the table, or in the grip of the tool."""

    name: str
    x_mm: float
    """Where its middle is: forward."""
    y_mm: float
    """Where its middle is: to the left."""
    bottom_mm: float
    """How high its underside is above the table."""
    turn_deg: float
    """How it is turned about the vertical, counter-clockwise."""
    size_mm: tuple[float, float, float]
    """Its sides along X, Y and Z before it is turned; of a cylinder twice the diameter, and the height."""
    mass_g: float
    color: str
    """As ``#rrggbb``."""
    held: bool
    """Whether it moves with the tool."""


@dataclass(frozen=True)
class World:
    """All that can be known of what is around a virtual arm, at a moment. In a notebook it shows itself."""

    time_s: float
    """The arm's time since power-up, in seconds."""
    objects: dict[str, Object]
    """The objects by their names."""
    ink: list[Stroke]
    """The lines of the pen, in the order in which they were drawn."""
    burns: list[Stroke]
    """The lines of the laser."""
    events: list[dict[str, Any]]
    """The last hundred things that happened, the oldest first: ``at_s``, ``event`` and what belongs to it."""
    state: dict[str, Any]
    """All of it, with the names of the API."""

    @classmethod
    def _of(cls, told: str) -> World:
        state = json.loads(told)
        objects = [_object(it, it["name"] in state["held"]) for it in state["objects"]]
        return cls(
            time_s=state["time_s"],
            objects={it.name: it for it in objects},
            ink=_lines(state["strokes"]),
            burns=_lines(state["burns"]),
            events=state["events"],
            state=state,
        )

    def svg(self) -> str:
        """It as a picture from above and from the side (SVG)."""
        return world_svg(json.dumps(self.state))

    def _repr_svg_(self) -> str:
        return self.svg()

    def __repr__(self) -> str:
        return f"<World: {len(self.objects)} objects, {len(self.ink)} lines of ink>"


def _lines(marks: list[dict[str, Any]]) -> list[Stroke]:
    return [[(x, y) for x, y in it["points_mm"]] for it in marks]


def _object(told: dict[str, Any], held: bool) -> Object:
    shape = told["shape"]
    if shape["type"] == "box":
        size = tuple(shape["size_mm"])
    else:
        size = (shape["diameter_mm"], shape["diameter_mm"], shape["height_mm"])
    return Object(
        name=told["name"], x_mm=told["at_mm"][0], y_mm=told["at_mm"][1], bottom_mm=told["bottom_mm"],
        turn_deg=told["turn_deg"], size_mm=size, mass_g=told["mass_g"], color=told["color"], held=held,
    )
