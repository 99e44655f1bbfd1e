"""Arms for tests: the fixture ``virtual_arm``, whose time passes only while a test waits, and ``served_arm`` on
a serial port.
"""

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
        help="behaviour of virtual arms: specification, or firmware-1.1 like the arms that were sold",
    )


def pytest_configure(config: pytest.Config) -> None:
    """Registers the marker ``dobot``."""
    config.addinivalue_line(
        "markers",
        "dobot(personality, world, faults, seed): the arm of the fixtures virtual_arm and served_arm: its behaviour, which "
        "overrides --dobot-personality; its scene, a file next to the test or its text; its faults",
    )


@pytest.fixture
def virtual_arm(request: pytest.FixtureRequest) -> Iterator[Arm]:
    """A virtual arm for this test, with the default rules; an hour of its time takes milliseconds."""
    personality, options = _options(request)
    with connect(f"virtual:{personality}", name="pytest", **options) as arm:
        yield arm


@pytest.fixture
def served_arm(request: pytest.FixtureRequest) -> Iterator[Served]:
    """A virtual arm for this test, for programs that use a serial port: ``served_arm.serial`` is its path.

    Its time runs as fast as the program responds.
    """
    personality, options = _options(request)
    with serve(personality, speed="max", **options) as served:
        yield served


def _options(request: pytest.FixtureRequest) -> tuple[str, Mapping[str, Any]]:
    """Returns the personality and the other options of the marker."""
    marker = request.node.get_closest_marker("dobot")
    options = dict(marker.kwargs) if marker else {}
    if marker and (marker.args or not options or set(options) - set(_KEYS)):
        raise pytest.UsageError(f"the marker must be {_MARKER}, with at least one of these arguments")
    personality = options.pop("personality", request.config.getoption("--dobot-personality"))
    world = options.get("world")
    if isinstance(world, os.PathLike) or (isinstance(world, str) and world.endswith(".toml")):
        options["world"] = Path(request.path).parent / world
    return personality, options
