"""Spoken orders, with speech made by flite. ``VOICE_ALL=1`` measures all voices and sentences, with and without noise."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import wave
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import pytest

import dobot_arm as dobot

pytest.importorskip("pocketsphinx")
pytest.importorskip("numpy")

import numpy as np

from dobot_arm.hearing import Ear, Heard, Talk
from dobot_arm.listen import Listener, TalkListener

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
    return bytes(np.clip(samples, -32767, 32767).astype("<i2").tobytes())


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

ALL = os.environ.get("VOICE_ALL") == "1"
ROOMS = (QUIET_DB, NOISY_DB)


def heard(pcm: bytes, *, waits: bool = False) -> list[Heard]:
    ear = Ear()
    ear.waits_for_reply = waits
    return [what for piece in pieces(pcm) for what in ear.hear(piece)]


@pytest.mark.parametrize("room_db", ROOMS if ALL else ROOMS[1:])
def test_orders_after_the_wake_word_are_understood(room_db: float) -> None:
    voices, orders = (VOICES, ORDERS) if ALL else (VOICES[:1], ORDERS[::4])
    wanted = [Heard("order", order) for _ in voices for order in orders]
    everything = heard(in_room([(voice, f"robot, {order}") for voice in voices for order in orders], room_db, 1))
    # A stop in the middle of an order costs that order.
    found = [what for what in everything if what.what != "stop"]
    right = [a == b for a, b in zip(found, wanted)]
    wrong = [(b.words, a) for a, b in zip(found, wanted) if a != b]
    print(f"{room_db:.0f} dB: {sum(right)} of {len(wanted)}; stops: {len(everything) - len(found)}; {wrong}")
    assert len(found) == len(wanted)
    assert sum(right) >= len(wanted) * 58 / 60


@pytest.mark.parametrize("waits", [False, True])
def test_no_sentence_of_chatter_is_an_order(waits: bool) -> None:
    sentences = CHATTER if ALL else CHATTER[25:33]
    room = in_room([(VOICES[n % 3], sentence) for n, sentence in enumerate(sentences)], NOISY_DB, 2)
    found = heard(room, waits=waits)
    accepted = [what for what in found if what.what in ("order", "go", "no")]
    print(f"{len(accepted)} of {len(sentences)} accepted; stops: {sum(what.what == 'stop' for what in found)}")
    assert len(found) >= len(sentences) and not accepted


def test_stop_is_understood_within_half_a_second_and_without_the_wake_word() -> None:
    texts = ("stop!", "stop.", "robot, stop!", "please stop.")
    late: list[float] = []
    for n in range(20 if ALL else 4):
        voice, text = VOICES[n % 3], texts[n % 4]
        room, ear, spoken_s = in_room([(voice, text)], ROOMS[n % 2], n), Ear(), 0.0
        end_s = 1 + last_loud_s(voice, text)
        for piece in pieces(room, 640):
            spoken_s += 0.02
            if Heard("stop") in list(ear.hear(piece)):
                late.append(spoken_s - end_s)
                break
    print(f"{len(late)} of {20 if ALL else 4}; at most {max(late):.2f} s after the word")
    assert len(late) == (20 if ALL else 4) and max(late) <= 0.5


def test_go_and_no_are_understood_only_after_an_order() -> None:
    room = in_room([(VOICES[1], "go."), (VOICES[0], "robot, no.")], QUIET_DB, 3)
    assert [what.what for what in heard(room, waits=True)] == ["go", "no"]
    assert not {"go", "no"} & {what.what for what in heard(room)}


def test_silence_and_noise_are_nothing() -> None:
    assert heard(bytes(32_000 * 3)) == []
    assert [what for what in heard(in_room([], NOISY_DB, 4) * 5) if what.what != "nothing"] == []


def test_a_held_button_needs_no_wake_word() -> None:
    talk = Talk()
    for piece in pieces(in_room([(VOICES[0], "left ten")], QUIET_DB, 5)):
        assert talk.hear(piece) is None
    assert talk.end() == Heard("order", "left ten")
    assert talk.end() == Heard("nothing")


@pytest.fixture
def arm() -> Iterator[dobot.Arm]:
    with dobot.connect("virtual:") as arm:
        arm.move_to(220, 0, 20)
        yield arm


def listened(arm: dobot.Arm, *sentences: str) -> dobot.Pose:
    listener = Listener(arm, arm)
    for piece in pieces(in_room([(VOICES[0], sentence) for sentence in sentences], QUIET_DB, 6)):
        listener.hear(piece)
    listener.finish()
    return arm.pose


def test_an_order_moves_the_arm_only_after_go(arm: dobot.Arm, capsys: pytest.CaptureFixture[str]) -> None:
    assert listened(arm, "robot, left ten").y_mm == pytest.approx(0, abs=0.01)
    assert "left ten; go?" in capsys.readouterr().out
    assert listened(arm, "robot, left ten", "robot, no.").y_mm == pytest.approx(0, abs=0.01)
    assert listened(arm, "robot, left ten", "robot, go.").y_mm == pytest.approx(10, abs=0.01)
    assert "left ten: done" in capsys.readouterr().out


def test_an_order_that_nobody_confirms_is_forgotten(arm: dobot.Arm, capsys: pytest.CaptureFixture[str]) -> None:
    listener = Listener(arm, arm)
    for piece in pieces(in_room([(VOICES[0], "robot, left ten")], QUIET_DB, 6) + bytes(32_000 * 11)):
        listener.hear(piece)
    listener.finish()
    assert "left ten: forgotten, nobody said go" in capsys.readouterr().out


def test_stop_stops_the_arm_at_once(arm: dobot.Arm) -> None:
    listened(arm, "stop!")
    stop = arm.state().stop
    assert stop is not None and stop.reason == 'the word "stop" was heard'
    with pytest.raises(dobot.Refused):
        arm.say("left ten")


def test_a_spoken_order_is_limited_by_the_policy_and_marked(arm: dobot.Arm) -> None:
    with pytest.raises(dobot.Refused, match="a spoken order would be 60 mm") as refused:
        arm.say("left sixty", spoken=True)
    assert refused.value.kind == "policy"
    arm.say("left sixty")


def test_one_page_speaks_at_a_time_and_an_end_that_is_lost_is_noticed(capsys: pytest.CaptureFixture[str]) -> None:
    with dobot.connect("virtual:") as arm:
        listener = TalkListener(arm)
        spoken = list(pieces(in_room([(VOICES[0], "left ten")], QUIET_DB, 7)))
        listener.hear((7, piece) for piece in spoken)
        listener.hear([(8, spoken[0]), (8, b"")])
        listener.hear([(7, b"")])
        assert "client 7: left ten" in capsys.readouterr().out
        listener.hear((7, piece) for piece in spoken)
        for _ in range(3):
            listener.hear([])
        assert "client 7: left ten" in capsys.readouterr().out


def run(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-m", "dobot_arm.listen", *arguments], capture_output=True, text=True, timeout=120)


def test_the_program_hears_a_recording_and_says_what_is_wrong_with_another(tmp_path: Path) -> None:
    room = in_room([(VOICES[0], "robot, up five"), (VOICES[0], "robot, go.")], QUIET_DB, 8)
    done = run("--to", "virtual:", "--wav", str(save(tmp_path / "orders.wav", room)))
    assert done.returncode == 0, done.stderr
    assert done.stdout.splitlines()[1:] == ["up five; go?", "up five: go", "up five: done"]
    wrong = run("--to", "virtual:", "--wav", str(save(tmp_path / "fast.wav", room, 44_100)))
    assert wrong.returncode == 1 and "44100 Hz, 16 bits, 1 channels; allowed are 16000 Hz" in wrong.stderr


def test_a_station_knows_that_a_listener_runs(station: str) -> None:
    from urllib.request import urlopen

    from dobot_arm import _core
    from dobot_arm.stored import station_options

    def listens() -> str:
        with urlopen(f"{station}/api/v1/talk") as answer:
            return str(answer.read().decode())

    audio = _core.TalkAudio(station, station_options(None, None, None))
    assert listens() == '{"listens":false}'
    assert audio.fetch() == "[]"
    assert listens() == '{"listens":true}'
    with pytest.raises(ValueError, match="there is no station at `virtual:`"):
        _core.TalkAudio("virtual:", station_options(None, None, None))
