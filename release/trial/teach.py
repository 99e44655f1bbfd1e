"""Teaches two points with keys in a terminal, and saves them: `teach.py FILE COMMAND...`; the command saves into the file."""

import fcntl
import os
import pty
import re
import select
import struct
import sys
import termios
import time
from collections.abc import Callable
from pathlib import Path

LIMIT_S = 60
UP = b"\x1b[A"

file = Path(sys.argv[1])
child, terminal = pty.fork()
if child == 0:
    os.execvp(sys.argv[2], sys.argv[2:])
fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 30, 100, 0, 0))
screen = bytearray()


def text() -> str:
    return re.sub(r"\x1b.[0-9;?]*[a-zA-Z]", "", screen.decode(errors="replace"))


def shows(part: str) -> Callable[[], bool]:
    return lambda: part in text()


def saved() -> bool:
    return file.exists() and "p2" in file.read_text()


def press(keys: bytes, until: Callable[[], bool]) -> None:
    """Presses keys until something happens: a point is taught only at rest, and a key that repeats soon counts as held."""
    ends = time.monotonic() + LIMIT_S
    while not until():
        if time.monotonic() > ends:
            sys.exit(f"{keys!r} had no effect:\n{text()[-1500:]}")
        os.write(terminal, keys)
        pause = time.monotonic() + 2
        while (left := pause - time.monotonic()) > 0:
            if select.select([terminal], [], [], left)[0]:
                screen.extend(os.read(terminal, 65536))


press(b"", shows("at rest"))
press(b"\r", shows("▶   1"))
press(UP, shows("moving"))
press(b"\r", shows("▶   2"))
press(b"w", saved)
os.write(terminal, b"q")
_, status = os.waitpid(child, 0)
sys.exit(os.waitstatus_to_exitcode(status))
