"""What one more runtime costs its machine, and what one more watcher costs a runtime: memory and processor time.

Usage: python tools/bench/growth.py [WATCHERS] [SECONDS]. A runtime in wall time with one unit lies idle, then so many
others listen to all that it tells.
"""

import os
import re
import subprocess
import sys
import time
from contextlib import ExitStack
from pathlib import Path
from tempfile import TemporaryDirectory

from onika.desk.run.remote_runtime import RemoteRuntime, connect
from onika.wire import live


def family(root: int) -> list[int]:
    """A process and all that it has started."""
    parents: dict[int, list[int]] = {}
    for path in Path("/proc").glob("[0-9]*/stat"):
        try:
            words = path.read_text().rsplit(")", 1)[1].split()
        except OSError:
            continue
        parents.setdefault(int(words[1]), []).append(int(path.parent.name))
    whole = [root]
    for process in whole:
        whole += parents.get(process, [])
    return whole


def used(root: int) -> tuple[float, float]:
    """Seconds of processor time, and MB of memory of its own share, of a family of processes."""
    time_s, memory = 0.0, 0.0
    for process in family(root):
        words = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
        time_s += (int(words[11]) + int(words[12])) / 100
        share = re.search(r"^Pss:\s+(\d+)", Path(f"/proc/{process}/smaps_rollup").read_text(), re.MULTILINE)
        memory += int(share[1]) / 1e3 if share else 0.0
    return time_s, memory


def share(root: int, seconds: float, watchers: list[RemoteRuntime]) -> str:
    """What a family uses meanwhile."""
    before, began = used(root)[0], time.monotonic()
    while time.monotonic() < began + seconds:
        for watcher in watchers:
            for _ in watcher.events(0.0):
                pass
        time.sleep(0.02)
    time_s, memory = used(root)
    percent = (time_s - before) / (time.monotonic() - began) * 100
    return f"{percent:.1f} % of a core, {memory:.0f} MB in {len(family(root))} processes"


def main(count: int, seconds: float) -> None:
    """Measure all."""
    with TemporaryDirectory() as state, ExitStack() as kept:
        words = [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--no-fifo"]
        environment = os.environ | {"XDG_STATE_HOME": state}
        began = time.perf_counter()
        runtime = kept.enter_context(subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment))
        kept.callback(runtime.terminate)
        assert runtime.stdout is not None
        found = re.search(r"listening on (\S+), token in (.*)$", runtime.stdout.readline())
        assert found is not None
        token = Path(found[2]).read_text().strip()
        print(f"a runtime listens after {time.perf_counter() - began:.1f} s", flush=True)
        time.sleep(2.0)
        print(f"idle: {share(runtime.pid, seconds, [])}", flush=True)
        watchers: list[RemoteRuntime] = []
        for number in range(count):
            watcher = kept.enter_context(connect(found[1], token))
            watcher.ask(live.Attend(("*",)))
            watchers.append(watcher)
            if number + 1 in (1, count):
                print(f"{number + 1} watching: {share(runtime.pid, seconds, watchers)}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 16, float(sys.argv[2]) if len(sys.argv) > 2 else 8.0)
