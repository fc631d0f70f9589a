"""What a class costs on this machine: memory, processor, and how long an act takes to be answered at the last seat.

Usage: python tools/bench/classroom.py [SEATS] [SECONDS]. So many learners come one after the other, each with a page
that is open; then nobody does anything for a while; then each runs a program, all at a time, and again nobody does
anything, first for a moment, then until all seats repose; then one seat is flooded.
"""

import json
import sys
import tempfile
import time
from contextlib import ExitStack
from pathlib import Path
from statistics import median

sys.path.insert(0, str(Path(__file__).parents[2] / "tests"))

from growth import family, used
from websockets.sync.client import ClientConnection

from kit.process.class_process import ClassProcess, done, until
from onika.web.repose import UNTOUCHED_S


def answered_ms(socket: ClientConnection, times: int = 9) -> str:
    """How long acts take that do something: a blank application is opened and closed."""
    took = []
    for _ in range(times):
        began = time.perf_counter()
        doc = done(socket, t="NewApplication")["value"]
        took.append((time.perf_counter() - began) * 1e3)
        done(socket, t="Close", doc=doc, discards=True)
    return f"{median(took):.0f} ms, at worst {max(took):.0f} ms"


def cost(pid: int, seconds: float) -> str:
    """What all processes of the class use meanwhile."""
    before, began = used(pid)[0], time.monotonic()
    time.sleep(seconds)
    time_s, memory = used(pid)
    percent = (time_s - before) / (time.monotonic() - began) * 100
    return f"{memory:.0f} MB in {len(family(pid))} processes, {percent:.0f} % of a core"


def main(seats: int, seconds: float) -> None:
    """Measure all."""
    with tempfile.TemporaryDirectory() as folder, ExitStack() as kept:
        began = time.perf_counter()
        school = ClassProcess(Path(folder), "--seats", str(seats), "go_home")
        kept.callback(school.end)
        print(f"open after {time.perf_counter() - began:.1f} s: {cost(school.pid, 2.0)}", flush=True)
        began, sockets, docs = time.perf_counter(), [], []
        for number in range(seats):
            browser = school.joined(f"learner {number + 1}")
            sockets.append(kept.enter_context(browser.talk()))
            tree = until(sockets[-1], lambda message: message["t"] == "Snapshot")["tree"]
            docs.append(next(iter(tree["applications"])))
        print(f"{seats} learners came within {time.perf_counter() - began:.1f} s", flush=True)
        print(f"idle, pages open: {cost(school.pid, seconds)}", flush=True)
        print(f"an act at the last seat: {answered_ms(sockets[-1])}", flush=True)
        began = time.perf_counter()
        for socket, doc in zip(sockets, docs, strict=True):
            socket.send(json.dumps({"cid": 9, "act": {"t": "Run", "doc": doc}}))
        print(f"an act at the last seat while all begin a run: {answered_ms(sockets[-1])}", flush=True)
        names = [f"learner {number + 1}" for number in range(seats)]
        school.teacher.until(lambda rows: all(rows[name]["run"] == "completed" for name in names))
        print(f"all have run it to its end after {time.perf_counter() - began:.1f} s", flush=True)
        print(f"idle, with a runtime each: {cost(school.pid, seconds)}", flush=True)
        time.sleep(UNTOUCHED_S + 5.0)
        print(f"in repose, pages open: {cost(school.pid, 3 * seconds)}", flush=True)
        print(f"the first act after it: {answered_ms(sockets[-1], 1)}", flush=True)
        flood = json.dumps({"cid": 1, "act": {"t": "Undo", "doc": docs[0]}})
        for _ in range(5000):
            sockets[0].send(flood)
        print(f"an act at the last seat while the first one floods: {answered_ms(sockets[-1])}", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 20, float(sys.argv[2]) if len(sys.argv) > 2 else 10.0)
