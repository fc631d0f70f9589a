import subprocess
import sys

TITLED = """
from pathlib import Path
from onika.host.processes.process_title import entitle
room = len(Path("/proc/self/cmdline").read_bytes())
for title in ("short", "x" * 10_000):
    entitle(title)
    shown = Path("/proc/self/cmdline").read_text()
    print(shown.rstrip("\\0") in (title, title[:room - 1]), len(shown) == room)
print(len(Path("/proc/self/environ").read_bytes()) > 0)
"""


def test_a_process_is_called_as_it_is_told_as_far_as_there_is_room():  # R-A15
    done = subprocess.run([sys.executable, "-c", TITLED], env={"KEPT": "1"}, capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["True"] * 5
