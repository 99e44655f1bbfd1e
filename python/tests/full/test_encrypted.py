"""A station with TLS, and the check of its certificate."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest

import dobot_arm as dobot


@pytest.fixture
def encrypted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[tuple[str, str, str]]:
    """The address of a station for other machines, its fingerprint, and a token for it."""
    program = os.environ.get("DOBOT")
    if program is None:
        pytest.skip("the environment variable DOBOT is not set to a `dobot` program")
    # The client belongs to another user, without a token of this station.
    monkeypatch.setenv("DOBOT_DATA", str(tmp_path / "elsewhere"))
    monkeypatch.delenv("DOBOT_TOKEN", raising=False)
    data = ["--data", str(tmp_path / "station")]
    added = [program, "token", "add", "control", "python", *data]
    token = subprocess.run(added, capture_output=True, text=True, check=True).stdout.strip()
    command = [program, "up", "--virtual", "--raw", "off", "--http", "0.0.0.0:0", *data]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True) as process:
        try:
            assert process.stdout is not None
            reported: dict[str, str] = {}
            for line in process.stdout:
                name, _, value = line.strip().partition(" ")
                reported[name] = value.strip()
                if "the arm is connected" in line:
                    break
            yield reported["page"], reported["fingerprint"], token
        finally:
            process.terminate()


def test_a_station_is_trusted_by_its_fingerprint(encrypted: tuple[str, str, str]) -> None:
    address, fingerprint, token = encrypted
    with dobot.connect(address, fingerprint=fingerprint, token=token) as arm:
        arm.confirm_pose()
        assert arm.move_to(220, 0, 20).x_mm == pytest.approx(220, abs=1)


def test_an_untrusted_certificate_is_refused(encrypted: tuple[str, str, str]) -> None:
    address, fingerprint, token = encrypted
    other = fingerprint[:-1] + ("0" if fingerprint[-1] != "0" else "1")
    with pytest.raises(dobot.LinkLost, match="not trusted"):
        dobot.connect(address, fingerprint=other, token=token)
    with pytest.raises(dobot.LinkLost, match="certificate"):
        dobot.connect(address, token=token)
    with pytest.raises(ValueError, match="not both"):
        dobot.connect(address, fingerprint=fingerprint, ca="ca.pem", token=token)
    with pytest.raises(ValueError):
        dobot.connect(address, fingerprint="no digest", token=token)
    with pytest.raises(dobot.LinkLost, match="none.pem"):
        dobot.connect(address, ca="none.pem", token=token)


def test_a_client_without_a_token_is_refused_with_the_reason(encrypted: tuple[str, str, str]) -> None:
    address, fingerprint, _ = encrypted
    with pytest.raises(dobot.Refused) as refused:
        dobot.connect(address, fingerprint=fingerprint, token="0" * 64)
    assert refused.value.kind == "unauthorised"
