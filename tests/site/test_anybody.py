"""Whatever sessions send to a runtime in wall time while an application runs: it lives, answers, and prints nothing.

A session that may only look changes nothing of the run beside it; see `message_fuzz`.
"""

import os
import subprocess
import sys
from typing import get_args

import pytest

from kit.plans.plan_builder import PlanBuilder, action
from kit.wire.message_fuzz import MessageFuzz
from kit.wire.request_crowd import honest_requests, names_of
from onika.desk.run.remote_runtime import RemoteRuntime
from onika.link.address import Address
from onika.link.websocket_opening import WebSocketOpening
from onika.wire import event, live, request
from onika.wire.plan import Plan
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason

pytestmark = pytest.mark.site

_PATIENCE_S = 40.0
"""Until a request is answered, on a machine that does other things too."""
_SESSION = 200
"""Requests of one session, before the next one comes."""

SOURCE = """
from onika.module import Module, OutVar

class Source(Module):
    X = OutVar("double", "m", "a level")

    def cycle(self):
        self.X = self.X + 1.0
"""
CLOCK = """
from onika.module import Input, InVar, Module, finish

class Clock(Module):
    trigger = True

    X = InVar("double", "m", "a level")

    count = Input("int", "-", "how many cycles", low=1, high=1000)

    def on(self, inputs):
        self._left = inputs.count

    def cycle(self):
        self._left -= 1
        return finish() if self._left <= 0 else None
"""


def plan(actions: int) -> Plan:
    """So many actions of a fifth of a second each."""
    shop = PlanBuilder()
    shop.task("source", SOURCE, frequency=50.0)
    shop.task("clock", CLOCK, frequency=50.0)
    return shop.plan([action("source", "clock", arguments="10")] * actions)


class Site:
    """A runtime process that listens; what it and its processes print is kept in a file."""

    def __init__(self, folder):
        users = folder / "users"
        self.tokens = {role: self._token(role, users) for role in ("owner", "viewer")}
        self._output = folder / "output"
        with self._output.open("wb") as output:
            self.process = subprocess.Popen(
                [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--no-fifo", "--users", str(users)],
                stdout=subprocess.PIPE, stderr=output, env=os.environ | {"XDG_STATE_HOME": str(folder)},
            )  # fmt: skip
        first = self.process.stdout.readline().decode()
        self.address = Address.parse(first.split(" on ")[1].split(",")[0].strip())

    def _token(self, role, users):
        words = [sys.executable, "-m", "onika.host.sessions.users", role, role, str(users)]
        return subprocess.run(words, check=True, capture_output=True, text=True).stdout.strip()

    def connect(self, role="owner"):
        return RemoteRuntime(WebSocketOpening(self.address, self.tokens[role], None))

    def close(self):
        """End it; what was printed since it listens."""
        self.process.terminate()
        rest, _ = self.process.communicate(timeout=60)
        assert self.process.returncode == 0
        return rest.decode() + self._output.read_text()


@pytest.fixture
def site(tmp_path):
    running = Site(tmp_path)
    yield running
    if running.process.poll() is None:
        running.process.kill()
        running.process.communicate()


class Anybody:
    """One session after the other that asks whatever comes to its mind."""

    def __init__(self, site, role, seed, keeps=lambda message: True):
        self._site, self._role, self._keeps = site, role, keeps
        plans = [plan(2), plan(50)]
        self.fuzz = MessageFuzz(get_args(request.Request), request.encode, seed, names_of(plans[0], "yard"))
        self._honest = honest_requests(plans, ("source", "clock"))
        self.answered = self.refused = 0

    def ask(self, count):
        """So many messages, each answered once; raises TimeoutError or LinkLost where one is not."""
        while count > 0:
            with self._site.connect(self._role) as session:
                for _ in range(min(count, _SESSION)):
                    self._send(session)
            count -= _SESSION

    def _send(self, session):
        random = self.fuzz.random
        body = request.encode(random.choice(self._honest)) if random.random() < 0.25 else self.fuzz.body(self._honest)
        if self._ends_the_tale(body):
            return
        answer = request.decode_response(session._connection.request(body, _PATIENCE_S, once=True))
        self.answered += 1
        self.refused += isinstance(answer, request.Refused)
        session._connection.poll(0.0)

    def _ends_the_tale(self, body):
        try:
            message = request.decode_request(body)
        except Exception:
            return False
        return isinstance(message, request.Quit) or not self._keeps(message)


def begun(runtime, actions):
    """An application of so many actions runs."""
    runtime.ask(live.Attend(("*",)))
    prepared = runtime.ask(request.Prepare(plan(actions), ()))
    assert isinstance(prepared, request.Prepared) and not prepared.faults, prepared
    assert not isinstance(runtime.ask(request.Begin()), request.Refused)


def test_who_may_only_look_changes_nothing_of_a_run(site):  # R-F01, R-X12
    with site.connect() as owner:
        begun(owner, 20)
        anybody = Anybody(site, "viewer", 1, keeps=lambda message: not isinstance(message, request.Stop))
        told = []
        for _ in range(60):
            anybody.ask(10)
            told += owner.events(0.0)  # whoever begins a run has to be heard
        for _ in range(1_000):
            if any(isinstance(message, event.Result) for message in told):
                break
            told += owner.events(0.1)
    began = [message.index for message in told if isinstance(message, event.Began)]
    result = next(message for message in told if isinstance(message, event.Result))
    assert began == list(range(20))
    assert result.completed, result.cause
    assert not any(isinstance(message, event.Stopped) for message in told)
    assert anybody.answered > 500
    printed = site.close()
    assert "Traceback" not in printed


def owner_asks(site, seed, count):
    anybody = Anybody(site, "owner", seed)
    for _ in range(0, count, 1000):
        with site.connect() as owner:
            owner.ask(live.Reset())
            owner.ask(request.Abort(Reason.plain("anew")))
            prepared = owner.ask(request.Prepare(plan(50), ()))
            if isinstance(prepared, request.Prepared) and not prepared.faults:
                owner.ask(request.Begin(on_loss="run"))
        anybody.ask(min(count, 1000))
    with site.connect() as owner:
        assert isinstance(owner.ask(live.Survey()), Standing)
    assert "Traceback" not in site.close()


def test_no_request_ends_a_runtime_in_wall_time(site):  # R-F01
    owner_asks(site, 1, 600)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2, 12))
def test_no_request_ends_a_runtime_in_wall_time_in_a_long_time(site, seed):  # R-F01
    owner_asks(site, seed, 10_000)
