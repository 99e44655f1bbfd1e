"""Recognises spoken orders: ``pip install dobot-arm[voice]``. Everything runs on this computer.

A grammar has only the arm's orders, so that few words are confused. It would also hear an order in every other sentence:
a second decoder follows the same sound without words, and an order counts only if its words fit almost as well.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator
from dataclasses import dataclass
from math import log10
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, Literal

try:
    import pocketsphinx  # type: ignore[import-untyped]
except ImportError as _missing:  # pragma: no cover
    raise ImportError("hearing needs pocketsphinx: pip install dobot-arm[voice]") from _missing

RATE = 16_000
"""Samples a second; 16 bits, little-endian, one channel."""
WAKE_WORD = "robot"

_SAMPLE = 2
_LEAST_FIT, _LEAST_GO_FIT = -4.4e-4, -2.5e-4
"""How much worse than the sounds alone the words may fit, as a score of each frame; "go" alone moves the arm, and is short."""
_SCORES_PER_S = 100
_SHORTEST_WORD_S, _LEAST_COVERED = 0.1, 0.75
"""The shortest word, and the least part of what was said that the words cover."""
_STOPS = {"stop": "1e-14", "please stop": "1e-20"}
"""What stops, and how easily it is found: "stop" after another word sounds different."""
_LONGEST_S = 6.0
"""The longest sentence that can be an order."""
_FRAME_S = 0.02
_FRAME = round(_FRAME_S * RATE) * _SAMPLE
_ROOM_S = 4.0
"""The room is as loud as the quietest moment of this time."""
_ABOVE_DB = 9.0
"""How much louder than the room a voice is."""
_BEFORE_S, _PAUSE_S = 0.4, 0.5
"""How much sound before the first loud part belongs to a sentence, and the silence that ends it."""
_STRAY = 3
"""So many loud frames within a pause are no voice."""
_RESTART_S = 20.0
"""How often the search for "stop" begins again: its memory grows while it runs."""

_UNITS = "one two three four five six seven eight nine"
_TEENS = "ten eleven twelve thirteen fourteen fifteen sixteen seventeen eighteen nineteen"
_TENS = "twenty thirty forty fifty sixty seventy eighty ninety"
_DIRECTIONS = "ahead back left right up down"


def _any_of(words: str) -> str:
    return "(" + " | ".join(words.split()) + ")"


def _grammar(sentences: str) -> str:
    return f"""#JSGF V1.0;
grammar orders;
<number> = {_any_of(_UNITS)} | {_any_of(_TEENS)} | {_any_of(_TENS)} [{_any_of(_UNITS)}] | hundred;
<order> = {_any_of(_DIRECTIONS)} <number> | catch | release;
<reply> = go | no;
public <sentence> = {sentences};
"""


_GRAMMARS = {
    "order": _grammar(f"{WAKE_WORD} <order>"),
    "reply": _grammar(f"{WAKE_WORD} <order> | [{WAKE_WORD}] <reply>"),
    "talk": _grammar(f"[{WAKE_WORD}] <order> | [{WAKE_WORD}] <reply>"),
}


@dataclass(frozen=True)
class Heard:
    """What was understood of something that was said."""

    what: Literal["order", "go", "no", "stop", "nothing"]
    """An order; "go" and "no" to the order before; "stop"; or nothing that fits."""
    words: str = ""
    """The words of an order, as for :meth:`Arm.say`."""


class Ear:
    """Hears orders in a stream of sound: "robot, left ten", then "go" or "no"; and "stop" at any time."""

    def __init__(self) -> None:
        self._sentence = _Sentence("order", _BEFORE_S + _PAUSE_S)
        self._stop = _Stop()
        self._pause = _Pause()
        self._rest = b""

    @property
    def waits_for_reply(self) -> bool:
        """Whether "go" and "no" are understood, too: an order was shown and waits for one of them."""
        return self._sentence.grammar == "reply"

    @waits_for_reply.setter
    def waits_for_reply(self, waits: bool) -> None:
        self._sentence.grammar = "reply" if waits else "order"

    def hear(self, pcm: bytes) -> Iterator[Heard]:
        """What was understood up to the end of this piece of sound. Each sentence ends with a short silence."""
        self._rest += pcm
        while len(self._rest) >= _FRAME:
            frame, self._rest = self._rest[:_FRAME], self._rest[_FRAME:]
            if self._stop.hear(frame):
                self._sentence.drop()
                yield Heard("stop")
            spoken, ends = self._pause.split(frame)
            self._sentence.hear(spoken)
            if ends:
                yield self._sentence.end()


class Talk:
    """Hears one sentence that lasts as long as a person holds a button; no wake word is needed."""

    def __init__(self) -> None:
        self._sentence = _Sentence("talk", _LONGEST_S)
        self._stop = _Stop()

    def hear(self, pcm: bytes) -> Heard | None:
        """Takes a piece of sound; returns only "stop", at once."""
        self._sentence.hear(pcm)
        return Heard("stop") if self._stop.hear(pcm) else None

    def end(self) -> Heard:
        """What was understood; the next sentence may begin."""
        self._stop.restart()
        return self._sentence.end()


class _Pause:
    """Splits sound into sentences, by its loudness above that of the room."""

    def __init__(self) -> None:
        self._loudness: deque[float] = deque(maxlen=round(_ROOM_S / _FRAME_S))
        self._before: deque[bytes] = deque(maxlen=round(_BEFORE_S / _FRAME_S))
        self._loud: deque[bool] = deque(maxlen=round(_PAUSE_S / _FRAME_S))
        self._is_open = False

    def split(self, frame: bytes) -> tuple[bytes, bool]:
        """The part of a sentence, and whether it ends with it."""
        samples = memoryview(frame).cast("h")
        # Differences of neighbours: the hum of a room counts less than a voice.
        power = sum((b - a) ** 2 for a, b in zip(samples[::4], samples[1::4]))
        self._loudness.append(10 * log10(1 + power))
        self._loud.append(self._loudness[-1] > min(self._loudness) + _ABOVE_DB)
        if self._is_open:
            self._is_open = sum(self._loud) > _STRAY
            return frame, not self._is_open
        self._before.append(frame)
        if sum(self._loud) <= _STRAY:
            return b"", False
        self._is_open = True
        spoken = b"".join(self._before)
        self._before.clear()
        return spoken, False


class _Sentence:
    """A sentence by the words of a grammar, compared with its sounds alone."""

    def __init__(self, grammar: str, silence_s: float) -> None:
        """``silence_s`` is how much of a sentence is silence before and after it."""
        self._silence_s = silence_s
        self._words = _decoder(lm=None, bestpath=False)
        for name, text in _GRAMMARS.items():
            self._words.add_jsgf_string(name, text)
        self._sounds = _decoder(
            allphone=pocketsphinx.get_model_path("en-us/en-us-phone.lm.bin"), lm=None, lw=2.0, beam=1e-20, pbeam=1e-20
        )
        self.grammar = grammar
        self._said = bytearray()

    def hear(self, pcm: bytes) -> None:
        if len(self._said) <= _LONGEST_S * RATE * _SAMPLE:
            self._said += pcm

    def drop(self) -> None:
        """Forgets what was said so far."""
        self._said.clear()

    def end(self) -> Heard:
        """Decodes the whole sentence at once: its mean loudness and tone are then known from the start."""
        said, self._said = bytes(self._said), bytearray()
        if not 0 < len(said) <= _LONGEST_S * RATE * _SAMPLE:
            return Heard("nothing")
        self._words.activate_search(self.grammar)
        for decoder in (self._words, self._sounds):
            decoder.start_utt()
            decoder.process_raw(said, full_utt=True)
            decoder.end_utt()
        words, sounds = self._words.hyp(), self._sounds.hyp()
        if words is None or sounds is None or not words.hypstr.strip():
            return Heard("nothing")
        frames = self._words.n_frames()
        lengths = [part.end_frame - part.start_frame + 1 for part in self._words.seg() if part.word[0] not in "<("]
        spoken = frames - self._silence_s * _SCORES_PER_S
        if min(lengths) < _SHORTEST_WORD_S * _SCORES_PER_S or sum(lengths) < _LEAST_COVERED * spoken:
            return Heard("nothing")
        fit = (words.best_score - sounds.best_score) / frames
        text = words.hypstr.removeprefix(WAKE_WORD).strip()
        if fit < (_LEAST_GO_FIT if words.hypstr == "go" else _LEAST_FIT):
            return Heard("nothing")
        return Heard("go") if text == "go" else Heard("no") if text == "no" else Heard("order", text)


class _Stop:
    """The word "stop", within whatever is said. Too many stops cost little, so it is found easily."""

    def __init__(self) -> None:
        with TemporaryDirectory() as folder:
            phrases = Path(folder, "stop.txt")
            phrases.write_text("".join(f"{phrase} /{least}/\n" for phrase, least in _STOPS.items()))
            self._decoder = _decoder(lm=None, kws=str(phrases))
        self._heard_s = 0.0
        self._decoder.start_utt()

    def hear(self, pcm: bytes) -> bool:
        self._decoder.process_raw(pcm)
        self._heard_s += len(pcm) / _SAMPLE / RATE
        found = self._decoder.hyp() is not None
        if found or self._heard_s > _RESTART_S:
            self.restart()
        return found

    def restart(self) -> None:
        self._decoder.end_utt()
        self._decoder.start_utt()
        self._heard_s = 0.0


def _decoder(**options: Any) -> Any:
    model = pocketsphinx.get_model_path
    return pocketsphinx.Decoder(
        pocketsphinx.Config(
            hmm=model("en-us/en-us"), dict=model("en-us/cmudict-en-us.dict"), samprate=RATE, loglevel="FATAL", **options
        )
    )
