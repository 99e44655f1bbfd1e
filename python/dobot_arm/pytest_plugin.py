"""Arms for tests: the fixture ``virtual_arm``, whose time passes only while something waits."""

from __future__ import annotations

from collections.abc import Iterator

import pytest

from . import Arm, connect


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
        "markers", "dobot(personality): how the arm of the fixture virtual_arm behaves, whatever --dobot-personality says"
    )


@pytest.fixture
def virtual_arm(request: pytest.FixtureRequest) -> Iterator[Arm]:
    """A virtual arm of this test's own, under the default rules; an hour of its time takes milliseconds."""
    marker = request.node.get_closest_marker("dobot")
    said = marker.kwargs if marker else {}
    if marker and (marker.args or set(said) != {"personality"}):
        raise pytest.UsageError('the marker is written as dobot(personality="firmware-1.1")')
    personality = said.get("personality", request.config.getoption("--dobot-personality"))
    with connect(f"virtual:{personality}", name="pytest") as arm:
        yield arm
