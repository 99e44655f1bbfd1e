"""Teaches two points with keys in a terminal of 100 columns, and saves them: `teach.py COMMAND...`."""

import fcntl
import os
import pty
import re
import select
import struct
import sys
import termios
import time

LIMIT_S = 60
UP = b"\x1b[A"
# What the screen shows, and the keys to press then, until the next text is there.
STEPS = [("loop", b"\r"), ("▶   1", UP), ("▶   1", UP), ("▶   1", UP), ("▶   1", b"\r"), ("▶   2", b"w"), ("saved", b"q")]


def shows(text: str, terminal: int, screen: bytearray, limit_s: float) -> bool:
    """Reads until the terminal has shown a text."""
    ends = time.monotonic() + limit_s
    while text not in re.sub(r"\x1b\[[0-9;?]*[a-zA-Z]", "", screen.decode(errors="replace")):
        ready, _, _ = select.select([terminal], [], [], max(0, ends - time.monotonic()))
        if not ready:
            return False
        try:
            screen += os.read(terminal, 65536)
        except OSError:
            return False
    return True


child, terminal = pty.fork()
if child == 0:
    os.execvp(sys.argv[1], sys.argv[1:])
fcntl.ioctl(terminal, termios.TIOCSWINSZ, struct.pack("HHHH", 30, 100, 0, 0))
screen = bytearray()
for (text, keys), (following, _) in zip(STEPS, [*STEPS[1:], ("", b"")], strict=True):
    if not shows(text, terminal, screen, LIMIT_S):
        sys.exit(f"`{text}` did not appear:\n{screen.decode(errors='replace')}")
    os.write(terminal, keys)
    # A place is taught once the arm is at rest: the key is pressed again until then.
    ends = time.monotonic() + LIMIT_S
    while keys in (b"\r", b"w") and not shows(following, terminal, screen, 0.5) and time.monotonic() < ends:
        os.write(terminal, keys)
_, status = os.waitpid(child, 0)
sys.exit(os.waitstatus_to_exitcode(status))
