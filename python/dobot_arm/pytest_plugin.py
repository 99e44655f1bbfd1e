"""Arms for tests: the fixture ``virtual_arm``, whose time passes only while something waits, and ``served_arm`` on a serial port."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import pytest

from . import Arm, Served, connect, serve

_MARKER = 'dobot(personality="firmware-1.1", world="desk.toml", faults=["drop=1%"], seed=0)'
_KEYS = ("personality", "world", "faults", "seed")


def pytest_addoption(parser: pytest.Parser) -> None:
    """Adds ``--dobot-personality``."""
    group = parser.getgroup("dobot", "virtual Dobot Arms")
    group.addoption(
        "--dobot-personality", default="specification", metavar="NAME",
        help="how virtual arms behave: specification, or firmware-1.1 as the arms that were sold do",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Tells of the marker ``dobot``."""
    config.addinivalue_line(
        "markers",
        "dobot(personality, world, faults, seed): the arm of the fixtures virtual_arm and served_arm: how it behaves, whatever "
        "--dobot-personality says; its scene, a file beside the test or its text; what goes wrong with it",
    )


@pytest.fixture
def virtual_arm(request: pytest.FixtureRequest) -> Iterator[Arm]:
    """A virtual arm of this test's own, under the default rules; an hour of its time takes milliseconds."""
    personality, options = _told(request)
    with connect(f"virtual:{personality}", name="pytest", **options) as arm:
        yield arm


@pytest.fixture
def served_arm(request: pytest.FixtureRequest) -> Iterator[Served]:
    """A virtual arm of this test's own for programs that speak serial: ``served_arm.serial`` is the name of its port.

    It lives as fast as the program answers.
    """
    personality, options = _told(request)
    with serve(personality, speed="max", **options) as served:
        yield served


def _told(request: pytest.FixtureRequest) -> tuple[str, Mapping[str, Any]]:
    """What the marker says of the arm: how it behaves, and the rest."""
    marker = request.node.get_closest_marker("dobot")
    said = dict(marker.kwargs) if marker else {}
    if marker and (marker.args or not said or set(said) - set(_KEYS)):
        raise pytest.UsageError(f"the marker is written as {_MARKER}, with one of these at least")
    personality = said.pop("personality", request.config.getoption("--dobot-personality"))
    world = said.get("world")
    if isinstance(world, os.PathLike) or (isinstance(world, str) and world.endswith(".toml")):
        said["world"] = Path(request.path).parent / world
    return personality, said
