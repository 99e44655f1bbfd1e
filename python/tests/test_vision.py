"""A camera, with photos rendered by ``crates/calibrate/examples/photos``: those of the page's tests."""

from __future__ import annotations

import json
import math
import os
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

import dobot_arm as dobot
from dobot_arm.vision import CROSSES, Cross, Eye, calibrate_from_photo, draw_crosses

NOWHERE = dobot.Status(0, 0, 0, 0, 0, 0, 0, 0, False, 0, at_s=0, moving=False)
ARMS = int(os.environ.get("PHOTOS_ARMS", "4"))


def photos(folder: Path, chosen: str, count: int, size: str = "640x480") -> list[tuple[Any, Any]]:
    """Rendered photos of a set, each with what is true."""
    program = os.environ.get("PHOTOS")
    if program is None:
        pytest.skip("the environment variable PHOTOS is not set to the example `photos`")
    subprocess.run([program, folder, chosen, str(count), size], check=True, stdout=subprocess.DEVNULL)
    files = sorted(folder.glob(f"{chosen}-*.ppm"))
    assert len(files) == count
    return [(cv2.imread(str(file)), json.loads(file.with_suffix(".json").read_text())) for file in files]


def test_objects_are_found_within_a_millimetre(tmp_path: Path) -> None:
    errors, turns, blobs = [], [], []
    for frame, truth in photos(tmp_path, "look", 6):
        marked, block = truth["objects"]
        seen = Eye(None, heights={7: marked["height_mm"]}).look(frame, hue_deg=0)
        assert seen.troubles == () and seen.typical_mm < 0.2
        place = seen.places[7]
        errors.append(math.hypot(place.x_mm - marked["x_mm"], place.y_mm - marked["y_mm"]))
        turns.append(abs((place.turn_deg - marked["turn_deg"] + 180) % 360 - 180))
        assert seen.blob is not None
        blobs.append(math.hypot(seen.blob.x_mm - block["x_mm"], seen.blob.y_mm - block["y_mm"]))
    assert np.median(errors) <= 0.5 and max(errors) <= 1.0
    assert max(turns) < 1.5 and max(blobs) < 3


@pytest.mark.parametrize(("chosen", "trouble"), [("blurred", "blurred"), ("glare", "glare"), ("covered", "few_corners")])
def test_a_bad_picture_is_reported(tmp_path: Path, chosen: str, trouble: str) -> None:
    ((frame, _),) = photos(tmp_path, chosen, 1)
    seen = Eye(None).look(frame)
    assert trouble in seen.troubles
    if trouble == "few_corners":
        assert not seen.places and math.isnan(seen.typical_mm)


def test_an_arm_is_calibrated_by_one_photo_of_crosses(tmp_path: Path) -> None:
    errors = []
    for frame, truth in photos(tmp_path, "crosses", ARMS, "1024x768"):
        drawn = [
            Cross(wanted, replace(NOWHERE, **dict(zip(("base_deg", "rear_deg", "fore_deg"), cross["raw_deg"]))))
            for wanted, cross in zip(CROSSES, truth["crosses"])
        ]
        # The tool of a random arm is up to 10 mm off; its owner has measured it.
        found = calibrate_from_photo(drawn, frame, tool_measured=True)
        for check in truth["checks"]:
            x, y, _ = found.true_place(*check["raw_mm"])
            errors.append(math.hypot(x - check["at_mm"][0], y - check["at_mm"][1]))
    half, most = np.percentile(errors, [50, 95])
    print(f"{ARMS} arms: {half:.2f} mm, {most:.2f} mm (50, 95 of 100)")
    assert most <= 0.5


def test_a_photo_without_the_crosses_is_refused(tmp_path: Path) -> None:
    ((frame, _),) = photos(tmp_path, "still", 1)
    drawn = [Cross(wanted, NOWHERE) for wanted in CROSSES]
    with pytest.raises(dobot.Error, match="of 25 crosses were found"):
        calibrate_from_photo(drawn, frame)
    ((covered, _),) = photos(tmp_path, "covered", 1)
    with pytest.raises(dobot.Error, match="fewer than three markers"):
        calibrate_from_photo(drawn, covered)


@pytest.mark.dobot(personality="firmware-1.1", world="[pen]\ndown_z_mm = -40\n")
def test_the_arm_draws_the_crosses_and_knows_where_it_stood(virtual_arm: dobot.Arm) -> None:
    drawn = draw_crosses(virtual_arm, -40.5)
    assert [cross.wanted for cross in drawn] == list(CROSSES)
    for cross in drawn:
        assert math.hypot(cross.status.x_mm - cross.wanted[0], cross.status.y_mm - cross.wanted[1]) < 0.2
    ink = np.concatenate([np.asarray(stroke)[:, :2] for stroke in virtual_arm.world().ink])
    for x, y in CROSSES:
        own = ink[np.hypot(*(ink - (x, y)).T) < 10]
        # Four ends, 4 mm from the middle.
        assert max(np.hypot(*(own - (x, y)).T)) == pytest.approx(4, abs=0.2)
        assert own.mean(axis=0) == pytest.approx((x, y), abs=1)


@pytest.mark.dobot(personality="firmware-1.1")
def test_a_program_goes_where_the_marker_is_seen(virtual_arm: dobot.Arm, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ((frame, truth),) = photos(tmp_path, "still", 1)
    (cube,) = truth["objects"]
    eye = Eye(None, heights={7: cube["height_mm"]})
    monkeypatch.setattr(eye, "frame", lambda: frame)
    program = dobot.program(steps=[
        {"go": {"x": 200, "y": 0, "z": 20}, "path": "movj"},
        {"go": {"from": "seen", "marker": 7}, "path": "movj"},
    ])
    virtual_arm.run(program, ask=eye.ask(z_mm=-40))
    pose = virtual_arm.pose
    assert (pose.x_mm, pose.y_mm, pose.z_mm) == pytest.approx((cube["x_mm"], cube["y_mm"], -40 + cube["height_mm"]), abs=0.5)


def test_a_marker_that_is_not_seen_is_reported(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    ((frame, _),) = photos(tmp_path, "still", 1)
    eye = Eye(None)
    monkeypatch.setattr(eye, "frame", lambda: frame)
    question = dobot.Question(text="Where is marker 9?", answers=(), place="marker 9", by="seen")
    with pytest.raises(dobot.Error, match="marker 9 was not seen for 0.1 s"):
        eye.ask(z_mm=-40, timeout=0.1)(question)


def test_an_eye_without_a_camera_says_so() -> None:
    with pytest.raises(dobot.Error, match="has no camera"):
        Eye(None).look()
    with pytest.raises(dobot.Error, match="cannot be opened"):
        Eye("/nowhere/camera.mp4")
