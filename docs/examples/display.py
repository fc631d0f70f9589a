"""A data display in a terminal, as an outside partner of the task `display`: one row a number, with its recent course.

    python docs/examples/display.py tcp:127.0.0.1:7801

Without an address it talks over its standard input and output and draws on the terminal it was started from. `--plain`
prints one line for each message instead. Nothing but Python is needed.
"""

import json
import math
import os
import socketserver
import sys
import threading
from collections import deque
from contextlib import suppress
from pathlib import Path

BARS = " ▁▂▃▄▅▆▇█"
KEPT = 60


class Screen:
    """Draws what several tasks show; one of them at a time."""

    def __init__(self, out, plain):
        self.out, self.plain = out, plain
        self.courses, self.lock = {}, threading.Lock()

    def show(self, task, message):
        """One message of a task: `values` by name, each a list of numbers, in one unit, at the time `t`."""
        with self.lock:
            rows = []
            for name, numbers in message["values"].items():
                for index, number in enumerate(numbers):
                    key = (task, name, index)
                    course = self.courses.setdefault(key, deque(maxlen=KEPT))
                    course.append(float("nan") if number is None else number)
                    rows.append(f"{name}[{index}] {course[-1]:+9.4f} {message['unit']}  {sparks(course)}")
            if self.plain:
                print(task, f"{message['t']:.3f}", json.dumps(message["values"]), file=self.out, flush=True)
            else:
                head = f"\x1b[H\x1b[2J{task}  t = {message['t']:.3f} s"
                print(head, *rows, sep="\n", file=self.out, flush=True)


def sparks(course):
    """A course as small bars between its lowest and its highest number."""
    finite = [number for number in course if math.isfinite(number)]
    low, span = min(finite, default=0.0), (max(finite, default=0.0) - min(finite, default=0.0)) or 1.0
    return "".join(BARS[1 + int(7.999 * (n - low) / span)] if math.isfinite(n) else BARS[0] for n in course)


def serve(lines, answer, screen):
    """One line, one answer, until the task hangs up."""
    for line in lines:
        message = json.loads(line)
        if message["ask"] == "show":
            screen.show(message["task"], message)
            answer({"id": message["id"]})
        else:
            answer({"id": message["id"], "error": f"a display does not know how to {message['ask']}"})


class Handler(socketserver.StreamRequestHandler):
    """One task that has called."""

    def handle(self):
        """Until it hangs up."""
        serve(self.rfile, lambda one: self.wfile.write(json.dumps(one).encode() + b"\n"), self.server.screen)


class Tcp(socketserver.ThreadingTCPServer):
    """Listens on a port."""

    allow_reuse_address, daemon_threads = True, True


class Unix(socketserver.ThreadingUnixStreamServer):
    """Listens on a path."""

    daemon_threads = True


def listen(address):
    """A server at `tcp:HOST:PORT` or `unix:PATH`."""
    kind, _, place = address.partition(":")
    if kind == "unix":
        Path(place).unlink(missing_ok=True)
        return Unix(place, Handler)
    host, _, port = place.rpartition(":")
    return Tcp((host, int(port)), Handler)


def terminal():
    """Where to draw when the standard output belongs to the task."""
    try:
        return Path("/dev/tty").open("w")
    except OSError:
        return sys.stderr


def main(words):
    """Listen at the address given, or where the task that started this says, or talk over standard input and output."""
    plain = "--plain" in words
    addresses = [one for one in words if not one.startswith("--")] or [os.environ.get("ONIKA_PARTNER", "")]
    if addresses[0]:
        with listen(addresses[0]) as server:
            server.screen = Screen(sys.stdout, plain)
            server.serve_forever()
    else:
        screen = Screen(sys.stderr if plain else terminal(), plain)
        serve(sys.stdin, lambda one: print(json.dumps(one), flush=True), screen)


if __name__ == "__main__":
    with suppress(KeyboardInterrupt):
        main(sys.argv[1:])
