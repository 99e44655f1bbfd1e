"""Moves an arm by spoken orders: ``python -m dobot_arm.listen`` (``pip install dobot-arm[voice]``).

Say "robot, left ten", read what was understood, here or on the station's page, and say "go" or "no". "Stop" works at any
time. Pages of the station get a button to talk while this runs.
"""

from __future__ import annotations

import argparse
import json
import shutil
import subprocess
import sys
import threading
import wave
from base64 import b64decode
from collections.abc import Iterable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import ExitStack

from . import _core
from .arm import Arm
from .errors import Closed, Error, Stopped
from .hearing import RATE, Ear, Heard, Talk
from .senses import add_arm_options, connect_both, is_station, release, stop
from .stored import station_options

_PIECE_BYTES = 3200
"""A tenth of a second."""
_REPLY_S = 10.0
"""How long an order waits for "go"."""
_STOP_REASON = 'the word "stop" was heard'
_SILENT_FETCHES = 3
"""So many requests without audio end what a page was saying: it was closed."""


class Listener:
    """Handles what is heard: shows an order, and sends it after "go"."""

    def __init__(self, arm: Arm, shown: Arm) -> None:
        """``arm`` moves, and ``shown`` shows and stops meanwhile; they may be the same."""
        self._arm, self._shown = arm, shown
        self._ear = Ear()
        self._order: str | None = None
        self._left_s = 0.0
        self._mover = ThreadPoolExecutor(1)
        self._motion: Future[None] | None = None

    def hear(self, pcm: bytes) -> None:
        """Takes a piece of sound: 16 kHz, 16 bits, one channel."""
        for heard in self._ear.hear(pcm):
            self._handle(heard)
        self._left_s -= len(pcm) / 2 / RATE
        if self._order and self._left_s <= 0:
            self._forget(f"{self._order}: forgotten, nobody said go")

    def finish(self) -> None:
        """Waits for the last motion."""
        self._mover.shutdown()

    def _handle(self, heard: Heard) -> None:
        if heard.what == "stop":
            self._stop()
        elif heard.what == "order":
            self._shown.report_heard("order", heard.words)
            print(f"{heard.words}; go?", flush=True)
            self._order, self._left_s, self._ear.waits_for_reply = heard.words, _REPLY_S, True
        elif heard.what != "nothing" and self._order:
            order = self._order
            self._shown.report_heard(heard.what)
            self._forget(f"{order}: {'go' if heard.what == 'go' else 'forgotten'}")
            if heard.what == "go":
                self._motion = self._mover.submit(self._move, order)

    def _forget(self, text: str) -> None:
        print(text, flush=True)
        self._order, self._ear.waits_for_reply = None, False

    def _stop(self) -> None:
        if self._motion is not None:
            self._motion.cancel()
        stop(self._shown, _STOP_REASON)
        if self._order:
            self._forget(f"{self._order}: forgotten")

    def _move(self, order: str) -> None:
        try:
            self._arm.say(order, spoken=True)
            print(f"{order}: done", flush=True)
        except Stopped:
            print(f"{order}: stopped", flush=True)
        except Error as error:
            print(f"{order}: {error}", flush=True)
        finally:
            # Others may move the arm between two orders.
            release(self._arm)


class TalkListener:
    """Hears what a person says while holding the button of a page; that page confirms and moves."""

    def __init__(self, shown: Arm) -> None:
        self._shown = shown
        self._talk = Talk()
        self._client: int | None = None
        self._silent = 0

    def hear(self, pieces: Iterable[tuple[int, bytes]]) -> None:
        """Takes pieces of sound with their clients; an empty one ends what is said."""
        self._silent += 1
        for client, pcm in pieces:
            self._silent = 0
            if self._client not in (None, client):
                if not pcm:  # One person at a time.
                    self._shown.report_heard("nothing", client=client)
                continue
            self._client = client
            if pcm and self._talk.hear(pcm):
                stop(self._shown, _STOP_REASON)
                self._shown.report_heard("stop", client=client)
            elif not pcm:
                self._end(client)
        if self._client is not None and self._silent >= _SILENT_FETCHES:
            self._end(self._client)

    def _end(self, client: int) -> None:
        heard = self._talk.end()
        self._client = None
        print(f"client {client}: {heard.words or heard.what}", flush=True)
        self._shown.report_heard(heard.what, heard.words, client=client)


def _talk(audio: _core.TalkAudio, listener: TalkListener, ends: threading.Event) -> None:
    """Serves the pages until the end; without the station it tries again."""
    while not ends.is_set():
        try:
            pieces = json.loads(audio.fetch())
            listener.hear((piece["client"], b64decode(piece["pcm"])) for piece in pieces)
        except Closed:
            return
        except Error as error:
            print(f"talk: {error}", file=sys.stderr, flush=True)
            ends.wait(2.0)


def _microphone(device: str | None) -> Iterator[bytes]:
    """Sound of the microphone, by PortAudio or by arecord."""
    try:
        import sounddevice  # type: ignore[import-untyped]
    except (ImportError, OSError):
        yield from _arecord(device)
        return
    try:
        with sounddevice.RawInputStream(RATE, _PIECE_BYTES // 2, device, 1, "int16") as stream:
            while True:
                yield bytes(stream.read(_PIECE_BYTES // 2)[0])
    except (sounddevice.PortAudioError, ValueError) as error:
        raise Error(f"the microphone cannot be opened: {error}; `python -m sounddevice` lists all") from error


def _arecord(device: str | None) -> Iterator[bytes]:
    program = shutil.which("arecord")
    if program is None:
        raise Error("there is no way to a microphone; install PortAudio (libportaudio2) or arecord (alsa-utils)")
    command = [program, "-q", "-t", "raw", "-f", "S16_LE", "-r", str(RATE), "-c", "1", *(["-D", device] if device else [])]
    with subprocess.Popen(command, stdout=subprocess.PIPE) as recorder:
        assert recorder.stdout is not None
        while pcm := recorder.stdout.read(_PIECE_BYTES):
            yield pcm
    raise Error(f"the recording ended: `{' '.join(command)}` returned {recorder.returncode}")


def _wave(path: str) -> Iterator[bytes]:
    with wave.open(path) as file:
        found = (file.getframerate(), file.getsampwidth(), file.getnchannels())
        if found != (RATE, 2, 1):
            raise Error(
                f"{path} has {found[0]} Hz, {8 * found[1]} bits, {found[2]} channels; allowed are {RATE} Hz, 16 bits,"
                f" one channel: `sox {path} -r {RATE} -b 16 -c 1 new.wav` converts it"
            )
        while pcm := file.readframes(_PIECE_BYTES // 2):
            yield pcm


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="python -m dobot_arm.listen", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    add_arm_options(parser)
    source = parser.add_mutually_exclusive_group()
    source.add_argument("--microphone", help="the microphone to use, by number or name")
    source.add_argument("--wav", metavar="FILE", help="hear a recording instead of a microphone")
    source.add_argument("--pages-only", action="store_true", help="no microphone: only what people say on pages")
    return parser.parse_args()


def _run(arguments: argparse.Namespace) -> None:
    if arguments.pages_only and not is_station(arguments.to):
        raise Error(f"pages belong to a station; {arguments.to} is an arm")
    ends = threading.Event()
    with ExitStack() as open_until_end:
        arm, shown = connect_both(arguments, "microphone", "listener", open_until_end)
        open_until_end.callback(ends.set)
        pages = None
        if is_station(arguments.to):
            audio = _core.TalkAudio(arguments.to, station_options(arguments.token, arguments.fingerprint, None))
            pages = threading.Thread(target=_talk, args=(audio, TalkListener(shown), ends), daemon=True)
            pages.start()
        print('listening: say "robot, left ten", then "go"; "stop" at any time' if not arguments.pages_only else "listening to pages", flush=True)
        if arguments.pages_only and pages:
            pages.join()
            return
        listener = Listener(arm, shown)
        for pcm in _wave(arguments.wav) if arguments.wav else _microphone(arguments.microphone):
            listener.hear(pcm)
        listener.finish()


def main() -> int:
    """Listens until Ctrl-C; returns the exit code."""
    try:
        _run(_arguments())
    except KeyboardInterrupt:
        pass
    except (Error, OSError, wave.Error) as error:
        print(f"error: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
