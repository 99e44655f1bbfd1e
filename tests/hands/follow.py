"""Shows `python -m dobot_arm.hands` a video of hands that are not open: they are found, and move nothing.

python tests/hands/follow.py VIDEO

The Python in the search path has the packages of tests/python/hands.txt and the package `dobot_arm`.
"""

import subprocess
import sys

command = [sys.executable, "-m", "dobot_arm.hands", "--to", "virtual:", "--video", sys.argv[1]]
done = subprocess.run(command, capture_output=True, text=True)
said = done.stdout.splitlines()
assert done.returncode == 0, done.stderr
assert "open your hand" in said, said
assert "the arm follows your hand" not in said, said
print(f"hands in a video: {', '.join(dict.fromkeys(said))}")
