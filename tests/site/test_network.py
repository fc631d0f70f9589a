"""A runtime that can be reached over a network: honest users are served, all others cost the robot nothing."""

import contextlib
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
from pathlib import Path
from time import monotonic

import pytest
from websockets.client import ClientProtocol
from websockets.uri import parse_uri

from kit.plans.plan_builder import PlanBuilder, action
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.remote_runtime import connect
from onika.link.address import Address
from onika.link.channel import Channel
from onika.link.lost import LinkLost, LossCause
from onika.link.websocket_opening import WebSocketOpening
from onika.wire import event, live, request, steer
from onika.wire.packet import VERSION, Hello, RequestPacket, encode
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason

pytestmark = pytest.mark.site

EXAMPLE = Path(__file__).parents[2] / "docs" / "examples" / "watch.mjs"
PYTHON = (sys.executable, "-m")
LEASE_S = 8.0
"""After so long a session that is not heard is gone."""


class Reachable:
    """A runtime process that listens."""

    def __init__(self, home, *options, listen="127.0.0.1:0"):
        self.environment = os.environ | {"XDG_STATE_HOME": str(home)}
        self.environment.pop("ONIKA_TOKEN", None)
        self.process = subprocess.Popen(
            [*PYTHON, "onika.host", "--listen", listen, *options],
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, env=self.environment,
        )  # fmt: skip
        self.said = self.process.stdout.readline()
        match = re.search(r"listening on (\S+?)(?:, token in (.*))?$", self.said)
        self.url = match[1] if match else ""
        self.token_file = Path(match[2]) if match and match[2] else None
        self.token = self.token_file.read_text().strip() if self.token_file else ""

    @property
    def port(self):
        return Address.parse(self.url).port

    def connect(self):
        return connect(self.url, self.token)

    def onika(self, *words):
        return [
            Path(sys.executable).with_name("onika"),
            *words,
            "--runtime",
            self.url,
            "--token-file",
            str(self.token_file),
        ]

    def close(self):
        self.process.terminate()
        code = self.process.wait(20)
        self.process.stdout.close()
        return code


@pytest.fixture
def reachable(tmp_path):
    started = []

    def start(*options, **named):
        started.append(Reachable(tmp_path, *options, **named))
        return started[-1]

    yield start
    for process in started:
        process.close()


def status(port, *lines, path="/", source="127.0.0.1"):
    """The HTTP status of a hand-made request."""
    upgrade = ("Connection: Upgrade", "Upgrade: websocket", "Sec-WebSocket-Version: 13",
               "Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==")  # fmt: skip
    with socket.create_connection(("127.0.0.1", port), 5.0, (source, 0)) as raw:
        raw.sendall("\r\n".join((f"GET {path} HTTP/1.1", *upgrade, *lines, "", "")).encode())
        return int(raw.recv(4096).split()[1])


def raw_client(reachable, name):
    """A connection for everything whose other side is this test, frame by frame."""
    carrier = WebSocketOpening(Address.parse(reachable.url), reachable.token)(Channel.ALL)
    carrier.send(encode(Hello(VERSION, name, "", 0)))
    return carrier


def test_an_application_runs_on_a_runtime_elsewhere_which_lives_on(reachable, tmp_path):  # R-A15, R-E14
    there = reachable("--virtual")
    for _ in range(2):
        done = subprocess.run(there.onika("run", "go_home"), check=False, capture_output=True, text=True, timeout=60,
                              env=there.environment)  # fmt: skip
        assert done.returncode == 0, done.stdout + done.stderr
        assert "completed" in done.stdout
    assert there.close() == 0


def test_strangers_are_turned_away_each_with_his_reason(reachable):  # R-F01
    port = reachable("--virtual").port
    host, mine = "Host: localhost", "127.0.0.2"
    assert status(port, host, source=mine) == 401
    assert status(port, host, "Authorization: Bearer wrong", source=mine) == 401
    assert status(port, "Host: evil.example", source=mine) == 403
    assert status(port, host, "Origin: https://evil.example", source=mine) == 403
    assert status(port, host, path="/elsewhere", source=mine) == 404
    with socket.create_connection(("127.0.0.1", port), 5.0, (mine, 0)) as raw:
        raw.sendall(b"GET / HTTP/1.1\r\nHost: localhost\r\n\r\n")
        assert raw.recv(4096).split()[1] == b"426"
    assert [status(port, host, source="127.0.0.3") for _ in range(11)] == [401] * 10 + [429]


def test_a_client_is_told_distinctly_what_is_wrong(reachable):
    there = reachable("--virtual")
    with pytest.raises(LinkLost) as wrong, connect(there.url, "wrong"):
        pass
    assert wrong.value.cause is LossCause.TOKEN
    assert "wrong" not in there.said
    with socket.socket() as unused:
        unused.bind(("127.0.0.1", 0))
        port = unused.getsockname()[1]
    with pytest.raises(LinkLost) as nobody, connect(f"ws://127.0.0.1:{port}", "x"):
        pass
    assert nobody.value.cause is LossCause.UNREACHABLE
    carrier = WebSocketOpening(Address.parse(there.url), there.token)(Channel.ALL)
    carrier.send(encode(Hello(1, "old", "", 0)))
    received = b""
    while b"version" not in received:
        with contextlib.suppress(BlockingIOError):
            received += b"".join(carrier.receive())
    carrier.close()


def test_an_honest_login_is_quick_beside_three_hundred_idle_connections(reachable):  # network.md F15
    there = reachable("--virtual")
    idle = [socket.create_connection(("127.0.0.1", there.port)) for _ in range(300)]
    try:
        began = monotonic()
        with there.connect() as runtime:
            assert isinstance(runtime.ask(live.Survey()), Standing)
        took = monotonic() - began
    finally:
        for idler in idle:
            idler.close()
    assert took < 5.0  # a greeting's whole deadline; an idle one in its way would cost that


def test_garbage_and_floods_and_those_who_never_read_do_not_hold_up_a_run(reachable):  # R-F01, network.md F8, F14
    there = reachable()
    frozen, flood = raw_client(there, "frozen"), raw_client(there, "flood")
    frozen.send(encode(RequestPacket(1, 1, 0, 0, request.encode(live.Attend(("*",))))))
    run = subprocess.Popen(there.onika("run", "go_home", "--json"), stdout=subprocess.PIPE, text=True,
                           env=there.environment)  # fmt: skip
    number = 1
    while run.poll() is None:
        with contextlib.suppress(OSError), socket.create_connection(("127.0.0.1", there.port), 1.0) as garbage:
            garbage.sendall(os.urandom(2000))
        for _ in range(100):
            if flood.pending < 100_000:
                flood.send(encode(RequestPacket(number, number, 0, 0, request.encode(live.Survey()))))
                number += 1
        with contextlib.suppress(LinkLost):
            flood.receive()
    output = run.stdout.read()
    run.stdout.close()
    frozen.close()
    flood.close()
    assert run.returncode == 0, output
    assert number > 1000
    figures = [(int(c), int(m)) for c, m in re.findall(r'"cycles": ?(\d+), ?"missed": ?(\d+)', output)]
    assert figures, output
    assert sum(missed for _, missed in figures) < 0.1 * sum(cycles for cycles, _ in figures)


def test_a_run_is_stopped_when_the_one_who_began_it_is_killed(reachable):  # R-X12
    there = reachable()
    run = subprocess.Popen(there.onika("run", "assemble"), stdout=subprocess.DEVNULL, env=there.environment)
    with there.connect() as watcher:
        watcher.ask(live.Attend(("*",)))
        wait_for(watcher, event.Began)
        run.kill()
        run.wait()
        result = wait_for(watcher, event.Result, 20.0)
    assert not result.completed


def wait_for(runtime, kind, seconds=30.0, when=lambda _one: True):
    until = monotonic() + seconds
    while monotonic() < until:
        for message in runtime.events(0.5):
            if isinstance(message, kind) and when(message):
                return message
    raise AssertionError(f"no {kind.__name__}")


@pytest.mark.parametrize("on_loss", ["finish", pytest.param("run", marks=pytest.mark.slow)])
def test_what_becomes_of_a_run_whose_client_is_killed_was_chosen_at_its_start(reachable, on_loss):  # R-E10
    there = reachable()
    words = there.onika("run", "assemble", "--on-loss", on_loss)
    run = subprocess.Popen(words, stdout=subprocess.DEVNULL, env=there.environment)
    with there.connect() as watcher:
        watcher.ask(live.Attend(("*",)))
        wait_for(watcher, event.Began)
        run.kill()
        run.wait(10)
        if on_loss == "finish":
            paused = wait_for(watcher, event.Moved, when=lambda moved: moved.state == "paused")
            # nothing moves again without a deliberate act, and whoever is there may do it
            assert watcher.ask(steer.Resume("flow0")) == request.Done()
            assert wait_for(watcher, event.Began).index == paused.action + 1
        else:
            refused = watcher.ask(request.Abort(Reason.plain("not mine")))
            assert "was begun by" in str(refused.reason)
            wait_for(watcher, event.Began, when=lambda began: began.at_s > LEASE_S)
            assert [flow.state for flow in watcher.ask(steer.Who()).flows] == ["running"]
        watcher.ask(request.Abort(Reason.plain("seen enough")))
        assert str(wait_for(watcher, event.Result).cause) == "seen enough"


BELL = """
from onika.module import Module, finish

class Bell(Module):
    trigger = True

    def cycle(self):
        return finish() if self.now > 2.0 else None
"""


def test_local_runs_go_on_when_the_porter_is_killed(monkeypatch, tmp_path):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    shop = PlanBuilder()
    shop.task("bell", BELL)
    with LaunchedRuntime(("rt0",), is_virtual=False, with_fifo=False, options=("--listen", "127.0.0.1:0")) as runtime:
        assert runtime.ask(request.Prepare(shop.plan([action("bell")]), ())).faults == ()
        assert runtime.ask(request.Begin()) == request.Done()
        os.kill(porter_of(runtime.pid), signal.SIGKILL)
        lost = wait_for(runtime, event.Lost)
        assert (lost.name, "killed by signal 9" in str(lost.cause)) == ("porter", True)
        assert wait_for(runtime, event.Result).completed


def porter_of(pid):
    for path in Path("/proc").glob("[0-9]*/cmdline"):
        with contextlib.suppress(OSError):
            words = path.read_bytes().replace(b"\0", b" ").split()
            if b"onika.host.sessions.listener_main" in words and str(pid).encode() in words:
                return int(path.parent.name)
    raise AssertionError("there is no porter")


def test_other_machines_are_let_in_with_certificate_and_users_only(tmp_path):  # R-X12
    words = [*PYTHON, "onika.host", "--listen", "0.0.0.0:0"]
    closed = subprocess.run(words, check=False, capture_output=True, text=True, timeout=60)
    assert closed.returncode == 2
    assert [line.partition(":")[0] for line in closed.stderr.splitlines()] == ["--users", "--cert", "--key"]


def test_over_tls_a_user_is_known_by_his_token_and_has_his_role(reachable, tmp_path):
    if shutil.which("openssl") is None:
        pytest.skip("there is no openssl to make a certificate with")
    cert, key, users = tmp_path / "cert.pem", tmp_path / "key.pem", tmp_path / "users"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes",
                    "-days", "2", "-subj", "/CN=onika", "-addext", "subjectAltName=IP:127.0.0.1",
                    "-keyout", str(key), "-out", str(cert)], check=True, capture_output=True)  # fmt: skip
    command = [*PYTHON, "onika.host.sessions.users", "ann", "viewer", str(users)]
    token = subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()
    there = reachable("--virtual", "--cert", str(cert), "--key", str(key), "--users", str(users), listen="0.0.0.0:0")
    assert there.url.startswith("wss://0.0.0.0:"), there.said
    url = f"wss://127.0.0.1:{there.port}"
    with connect(url, token, cert) as runtime:
        assert isinstance(runtime.ask(live.Survey()), Standing)
        assert "ann, who is viewer" in str(runtime.ask(request.Abort(Reason.plain("no"))).reason)
        assert not isinstance(runtime.ask(request.Stop(Reason.plain("everybody may"))), request.Refused)
    with pytest.raises(LinkLost) as untrusted, connect(url, token):
        pass
    assert untrusted.value.cause is LossCause.CERTIFICATE
    assert token not in users.read_text()


def test_a_client_in_another_language_needs_only_the_protocols_page(reachable):  # R-A19
    if shutil.which("node") is None:
        pytest.skip("there is no node")
    there = reachable("--virtual")
    watch = subprocess.Popen(["node", str(EXAMPLE), there.url, str(there.token_file), "3"], stdout=subprocess.PIPE,
                             text=True)  # fmt: skip
    lines = [watch.stdout.readline() for _ in range(3)]
    assert lines[0].startswith("linked, epoch ")
    assert '"type":"Standing"' in lines[1]
    assert '"type":"Done"' in lines[2]
    subprocess.run(there.onika("run", "go_home"), check=True, capture_output=True, timeout=60, env=there.environment)
    rest = watch.stdout.read().splitlines()
    watch.stdout.close()
    assert watch.wait(10) == 0
    assert len(rest) == 3


def test_a_hand_made_websocket_is_answered_as_the_page_says(reachable):  # R-A19
    there = reachable("--virtual")
    protocol = ClientProtocol(parse_uri(f"{there.url}/session"))
    greeting = protocol.connect()
    greeting.headers["Authorization"] = f"Bearer {there.token}"
    protocol.send_request(greeting)
    with socket.create_connection(("127.0.0.1", there.port)) as raw:
        raw.sendall(b"".join(protocol.data_to_send()))
        protocol.receive_data(raw.recv(4096))
        protocol.send_binary(b"\x95\xa5hello\x03\xa4desk\xa0\x00")
        raw.sendall(b"".join(protocol.data_to_send()))
        protocol.receive_data(raw.recv(4096))
    frames = [bytes(frame.data) for frame in protocol.events_received()[1:]]
    assert frames[0].startswith(b"\x96\xa7welcome\x03\xd9")
