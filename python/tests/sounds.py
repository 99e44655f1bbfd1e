"""Speech made by flite, in a room: the same sounds each time."""

from __future__ import annotations

import shutil
import subprocess
import wave
from collections.abc import Iterable
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
import pytest

Sound = Any
RATE = 16_000
VOICES = ("slt", "awb", "rms")
LEVEL = 2000.0
"""The mean loudness of speech, of 32767."""
QUIET_DB, NOISY_DB = 50.0, 30.0
"""How much quieter than speech the noise of a room is."""

ORDERS = (
    "left ten", "right ten", "ahead ten", "back ten", "up ten", "down ten", "left twenty", "right thirty", "ahead five",
    "back fifteen", "up twenty five", "down seven", "left forty", "right fifty", "ahead thirteen", "back two",
    "up twelve", "down eighteen", "catch", "release",
)

CHATTER = tuple(
    (Path(__file__).parent / "scenes" / "chatter.txt").read_text().splitlines()
)


@cache
def said(voice: str, text: str) -> Sound:
    """A sentence, without a room."""
    if shutil.which("flite") is None:
        pytest.skip("flite is not installed")
    with TemporaryDirectory() as folder:
        file = Path(folder, "said.wav")
        subprocess.run(["flite", "-voice", voice, "-t", text, "-o", file], check=True)
        with wave.open(str(file)) as sound:
            assert (sound.getframerate(), sound.getsampwidth(), sound.getnchannels()) == (RATE, 2, 1)
            samples = np.frombuffer(sound.readframes(sound.getnframes()), np.int16).astype(float)
    return samples * (LEVEL / np.sqrt(np.mean(samples**2)))


def in_room(sentences: Iterable[tuple[str, str]], noise_db: float, seed: int) -> bytes:
    """Sentences of voices, each after a second of silence, with pink noise."""
    parts = [np.concatenate([np.zeros(RATE), said(*sentence)]) for sentence in sentences]
    samples = np.concatenate([*parts, np.zeros(RATE)])
    random = np.random.default_rng(seed)
    hertz = np.fft.rfftfreq(len(samples), 1 / RATE)
    spectrum = random.normal(size=len(hertz)) + 1j * random.normal(size=len(hertz))
    spectrum[1:] /= np.sqrt(hertz[1:])
    spectrum[0] = 0
    noise = np.fft.irfft(spectrum, len(samples))
    samples = samples + noise * (LEVEL * 10 ** (-noise_db / 20) / noise.std())
    return np.clip(samples, -32767, 32767).astype("<i2").tobytes()


def pieces(pcm: bytes, size: int = 3200) -> Iterable[bytes]:
    """A tenth of a second each."""
    return (pcm[at : at + size] for at in range(0, len(pcm), size))


def last_loud_s(voice: str, text: str) -> float:
    """When a sentence ends, in seconds from its begin."""
    return float(np.flatnonzero(np.abs(said(voice, text)) > LEVEL / 10)[-1]) / RATE


def save(path: Path, pcm: bytes, rate: int = RATE) -> Path:
    """Saves a WAV file."""
    with wave.open(str(path), "wb") as file:
        file.setnchannels(1)
        file.setsampwidth(2)
        file.setframerate(rate)
        file.writeframes(pcm)
    return path
