"""Beats as datagrams, with real sockets: a short lease where they get through, and nobody else's count."""

import os
import re
import select
import socket
import subprocess
import sys
from contextlib import contextmanager
from pathlib import Path
from time import monotonic

import pytest

from onika.desk.run.remote_runtime import connect
from onika.link import websocket_opening
from onika.link.heartbeat import EVERY_NS, HeartbeatSender
from onika.wire import event, holding, live, request

pytestmark = pytest.mark.site


@pytest.fixture(scope="module")
def there(tmp_path_factory):
    """A runtime that listens on loopback: its address and token."""
    environment = os.environ | {"XDG_STATE_HOME": str(tmp_path_factory.mktemp("state"))}
    words = [sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0", "--no-fifo"]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment) as process:
        match = re.search(r"listening on (\S+), token in (.*)$", process.stdout.readline())
        yield match[1], Path(match[2]).read_text().strip()
        process.terminate()
        assert process.wait(20) == 0


def listen(*runtimes, until, seconds=20.0):
    """All of them beat and listen until this holds."""
    end = monotonic() + seconds
    while not until():
        assert monotonic() < end, "it did not come"
        select.select([fd for runtime in runtimes for fd in runtime.readers()], [], [], 0.02)
        for runtime in runtimes:
            runtime.received += list(runtime.messages())


@contextmanager
def session(there):
    with connect(*there) as runtime:
        runtime.received = []
        runtime.you = runtime.ask(holding.Sessions()).you
        runtime.ask(live.Attend(("*",)))
        yield runtime


def lease(asking, of):
    leases = {session.name: session.lease_s for session in asking.ask(holding.Sessions()).sessions}
    return leases[of.you]


def lost(watcher, subsystem):
    return [
        message
        for message in watcher.received
        if isinstance(message, event.Held) and message.subsystem == subsystem and not message.holder
    ]


def silent_s(message):
    return float(re.search(r"silent for ([0-9.]+) s", str(message.cause))[1])


def test_where_datagrams_get_through_silence_counts_after_a_quarter_of_a_second(there):  # R-X12, network.md D4
    with session(there) as watcher, session(there) as holder:
        assert holder.ask(live.Take("quick")) == request.Done()
        listen(watcher, holder, until=lambda: lease(watcher, holder) == 0.25)
        listen(watcher, until=lambda: lost(watcher, "quick"))  # the holder is not served any more: it is silent
        assert 0.25 <= silent_s(lost(watcher, "quick")[0]) < 0.75


def test_where_none_gets_through_it_counts_after_a_second(there, monkeypatch):  # R-X12
    monkeypatch.setattr(websocket_opening, "_heartbeat_sender", lambda *_: None)
    with session(there) as watcher, session(there) as holder:
        assert holder.ask(live.Take("slow")) == request.Done()
        end = monotonic() + 1.5
        listen(watcher, holder, until=lambda: monotonic() > end)
        assert not lost(watcher, "slow") and lease(watcher, holder) == 1.0
        listen(watcher, until=lambda: lost(watcher, "slow"))
        assert 1.0 <= silent_s(lost(watcher, "slow")[0]) < 1.75


class Eavesdropper(HeartbeatSender):
    """Keeps what is sent, and says it again whenever it is asked."""

    def __init__(self, heartbeat_key, host, family):
        super().__init__(heartbeat_key, host, family)
        self.at, self.beats = (host, heartbeat_key.port), [heartbeat_key.beat(count) for count in range(1, 40)]
        Eavesdropper.last = self


def test_beats_that_were_overheard_or_forged_keep_nobody_alive(there, monkeypatch):  # R-X12
    monkeypatch.setattr(websocket_opening, "HeartbeatSender", Eavesdropper)
    with session(there) as watcher, session(there) as holder:
        thief = Eavesdropper.last
        assert holder.ask(live.Take("robbed")) == request.Done()
        listen(watcher, holder, until=lambda: lease(watcher, holder) == 0.25)
        beats = monotonic() + 45 * EVERY_NS * 1e-9
        listen(watcher, holder, until=lambda: monotonic() > beats)  # its own count is beyond what was overheard
        forged = [beat[:-1] + bytes([beat[-1] ^ 1]) for beat in thief.beats]
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as air:

            def is_lost():
                for datagram in (*thief.beats, *forged, os.urandom(32), b"", os.urandom(2000)):
                    air.sendto(datagram, thief.at)
                return bool(lost(watcher, "robbed"))

            listen(watcher, until=is_lost)
        assert 0.25 <= silent_s(lost(watcher, "robbed")[0]) < 0.75
