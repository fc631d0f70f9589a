"""Real processes on a slow line that is cut and comes back (F4): everything once, in order."""

import contextlib
import os
import queue
import re
import socket
import subprocess
import sys
import threading
from pathlib import Path
from time import monotonic, sleep

import pytest

from kit.plans.plan_builder import PlanBuilder
from onika.desk.run.remote_runtime import connect
from onika.link.address import Address
from onika.wire import event, live

pytestmark = [pytest.mark.site, pytest.mark.slow]

COUNTER = """
from onika.module import Module, OutVar

class Counter(Module):
    COUNT = OutVar("double", "-", "cycles since it came on")

    def cycle(self):
        self.COUNT = self.COUNT + 1.0
"""


class SlowLine:
    """A line to a port of this machine, with so much delay each way; while it is cut nothing passes, either way."""

    def __init__(self, port, delay_s):
        self._port, self._delay_s = port, delay_s
        self._passes = threading.Event()
        self._passes.set()
        self._listener = socket.create_server(("127.0.0.1", 0))
        self._ends = []
        self._threads = []
        self.port = self._listener.getsockname()[1]
        self._begin(self._accept)

    def cut(self):
        self._passes.clear()

    def heal(self):
        self._passes.set()

    def close(self):
        self._passes.set()
        for end in (self._listener, *self._ends):
            with contextlib.suppress(OSError):
                end.shutdown(socket.SHUT_RDWR)
            end.close()
        for thread in self._threads:
            thread.join(10)

    def _begin(self, work, *given):
        thread = threading.Thread(target=work, args=given)
        self._threads.append(thread)
        thread.start()

    def _accept(self):
        while True:
            try:
                near, _ = self._listener.accept()
            except OSError:
                return
            far = socket.create_connection(("127.0.0.1", self._port))
            self._ends += [near, far]
            for source, target in ((near, far), (far, near)):
                waiting = queue.Queue()
                self._begin(self._take, source, waiting)
                self._begin(self._give, target, waiting)

    def _take(self, source, waiting):
        data = b"-"
        while data:
            try:
                data = source.recv(1 << 16)
            except OSError:
                data = b""
            waiting.put((monotonic() + self._delay_s, data))

    def _give(self, target, waiting):
        data = b"-"
        while data:
            due, data = waiting.get()
            sleep(max(due - monotonic(), 0.0))
            self._passes.wait()
            try:
                target.sendall(data) if data else target.shutdown(socket.SHUT_RDWR)
            except OSError:
                return


@pytest.fixture
def far(tmp_path):
    """A runtime in virtual time behind a line of 40 ms each way: where it is reached, its token, and the line."""
    environment = os.environ | {"XDG_STATE_HOME": str(tmp_path)}
    environment.pop("ONIKA_TOKEN", None)
    words = [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--virtual"]
    process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment)
    match = re.search(r"listening on (\S+?), token in (.*)$", process.stdout.readline())
    port = Address.parse(match[1]).port
    line = SlowLine(port, 0.04)
    yield match[1].replace(str(port), str(line.port)), Path(match[2]).read_text().strip(), line
    line.close()
    process.terminate()
    process.wait(20)
    process.stdout.close()


CUTS_S = {10: 1.0, 20: 3.0, 30: 1.0, 31: 0.3, 32: 0.3}
TURNS = 40


def test_on_a_slow_line_that_is_cut_everything_happens_once_and_is_told_in_order(far):  # R-F01
    url, token, line = far
    shop = PlanBuilder()
    shop.task("counter", COUNTER, frequency=100.0)
    numbers, events = [], []
    with connect(url, token) as runtime:
        runtime.ask(live.Attend(("*",)))
        order = live.Change("s0", spawn=(shop.planned("counter"),), code=(shop.code("counter"),))
        numbers.append(runtime.ask(order).number)
        for turn in range(TURNS):
            if turn in CUTS_S:
                line.cut()
                threading.Timer(CUTS_S[turn], line.heal).start()
            wish = {"off": ("counter",)} if turn % 2 else {"on": (live.Turn("counter"),)}
            numbers.append(runtime.ask(live.Change("s0", **wish)).number)
        until = monotonic() + 60.0
        while sum(isinstance(message, event.Edited) for message in events) <= TURNS and monotonic() < until:
            events += runtime.events(0.1)
    assert numbers == list(range(1, TURNS + 2))
    edited = [message for message in events if isinstance(message, event.Edited)]
    assert [message.number for message in edited] == numbers
    assert not any(message.cause for message in edited)
    states = [message.state for message in events if isinstance(message, event.TaskState)]
    assert states == ["OFF", *("ON" if turn % 2 == 0 else "OFF" for turn in range(TURNS))]
