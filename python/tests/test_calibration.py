"""Calibrations from touches."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest

import dobot_arm as dobot

WORLD = "[pen]\ndown_z_mm = -40\n"


def touches(arm: dobot.Arm) -> list[dobot.Touch]:
    """Touches of the points of the sheet, from the true position of the arm."""
    found = []
    for x, y in dobot.SHEET:
        reported = [x, y, -20.0]
        for _ in range(20):
            arm.move_to(*reported, path="movj")
            true = arm.world().state["arm"]
            off = [true["x_mm"] - x, true["y_mm"] - y, true["z_mm"] + 20]
            if math.hypot(*off) < 0.1:
                break
            reported = [a - b for a, b in zip(reported, off)]
        else:
            pytest.fail(f"it does not reach {x}, {y}")
        found.append(dobot.Touch(x, y, arm.next_status()))
    return found


@pytest.mark.dobot(personality="firmware-1.1", faults=["zero=rear:1.5", "zero=fore:-2"], world=WORLD)
def test_zeros_are_found_from_nine_touches(virtual_arm: dobot.Arm) -> None:
    found = dobot.calibrate(touches(virtual_arm))
    assert found.zeros_deg == pytest.approx((0, 1.5, -2), abs=0.2)
    assert found.trust == "good" and found.wrong == []
    assert max(found.residuals_mm) < 0.3 and found.expected_mm < 0.5
    # The raw position leads to the calibrated one.
    virtual_arm.move_to(*found.raw_place(230, 40, 0), path="movj")
    true = virtual_arm.world().state["arm"]
    assert math.dist((true["x_mm"], true["y_mm"], true["z_mm"]), (230, 40, 0)) < 0.5
    there = found.true_place(*found.raw_place(230, 40, 0))
    assert there == pytest.approx((230, 40, 0), abs=1e-6)
    assert "[zeros]" in found.text and found._repr_svg_().startswith("<svg")


@pytest.mark.dobot(world=WORLD)
def test_touches_that_tell_no_calibration_say_why(virtual_arm: dobot.Arm) -> None:
    good = touches(virtual_arm)
    with pytest.raises(ValueError, match="4"):
        dobot.calibrate(good[:3])
    wrong = [replace(good[0], x_mm=good[0].x_mm + 12), *good[1:]]
    assert dobot.calibrate(wrong).wrong == [0]
    with pytest.raises(ValueError):
        dobot.calibrate(good).raw_place(600, 0, 0)
