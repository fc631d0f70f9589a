import socket
import time
from pathlib import Path

import pytest

from kit.labs.library_server import LibraryServer, answer, drip, flood, moved, slow_head
from onika.store.remote.address import WebAddress, web_address
from onika.store.remote.credential import Credential
from onika.store.remote.limits import Limits
from onika.store.remote.source import Wanted
from onika.store.remote.web_connection import WebConnection
from onika.words.reason import Reason

HASTY = Limits(connect_s=2.0, idle_s=0.3, total_s=0.6, rate=1e6, grace_s=0.1)


_OPEN: list[WebConnection] = []


@pytest.fixture(autouse=True)
def closed():
    """What a test has opened is closed behind it."""
    yield
    while _OPEN:
        _OPEN.pop().close()


@pytest.fixture
def server(tmp_path: Path):
    (tmp_path / "library").write_bytes(b"an index")
    with LibraryServer(tmp_path) as server:
        yield server


def connection(server: LibraryServer, limits: Limits | None = None, credential: Credential | None = None):
    address = web_address(server.address)
    assert isinstance(address, WebAddress)
    _OPEN.append(WebConnection(address, limits or Limits(), credential))
    return _OPEN[-1]


def key(server: LibraryServer, path: str = "library", most: int = 1000, limits: Limits | None = None) -> str:
    """Why there is no answer; it comes in a moment, whatever the server does."""
    began = time.monotonic()
    reply = connection(server, limits or HASTY).get(Wanted(path, most))
    assert time.monotonic() - began < 5
    assert isinstance(reply, Reason), reply
    return reply.key


def test_files_come_over_one_connection(server):  # R-F03
    ours = connection(server)
    assert ours.get(Wanted("library", 1000)) == b"an index"
    assert ours.get(Wanted("library", 1000)) == b"an index"
    assert server.connections == 1


def test_a_connection_that_the_server_closed_meanwhile_is_opened_again(server):  # R-F03
    ours = connection(server)
    server.answers["bye"] = lambda there: (there.sendall(answer(b"x")), there.shutdown(socket.SHUT_RDWR))
    assert ours.get(Wanted("bye", 1000)) == b"x"
    assert ours.get(Wanted("library", 1000)) == b"an index"
    assert server.connections == 2


def test_what_is_not_there_is_said(server):  # R-F03
    assert key(server, "nothing") == "store.not_on_server"


def test_a_server_that_never_answers_is_left(server):  # R-X16
    server.answers["library"] = lambda _: server.stop.wait(10)
    assert key(server) == "store.server_silent"


def test_a_server_that_floods_is_left(server):  # R-X16
    server.answers["library"] = flood
    assert key(server, limits=Limits()) == "store.answer_large"


def test_more_than_was_signed_is_not_read(server):  # R-X16
    server.answers["library"] = lambda there: there.sendall(answer(b"", length=10**12))
    assert key(server) == "store.answer_large"


def test_a_server_that_answers_drop_by_drop_is_left(server):  # R-X16
    server.answers["library"] = drip(server.stop, 0.02)
    assert key(server, most=10**6) == "store.server_slow"


def test_a_head_that_does_not_end_is_left(server):  # R-X16
    server.answers["library"] = slow_head(server.stop, 0.05)
    assert key(server) == "store.server_slow"


def test_an_answer_that_is_cut_is_none(server):  # R-X16
    server.answers["library"] = lambda there: (
        there.sendall(answer(b"half", length=8)),
        there.shutdown(socket.SHUT_RDWR),
    )
    assert key(server) == "store.answer_cut"


def test_an_answer_that_is_none_is_said(server):  # R-X16
    server.answers["library"] = lambda there: there.sendall(b"\x00\xff" * 500 + b"\r\n\r\n")
    assert key(server) == "store.server_garbled"


def test_a_server_that_is_not_there_is_said():  # R-X16
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
    reply = WebConnection(WebAddress(False, "127.0.0.1", port, "/"), HASTY, None).get(Wanted("library", 9))
    assert isinstance(reply, Reason) and reply.key == "store.server_unreached"


def test_a_server_may_send_on_to_itself_only(server):  # R-X16
    server.answers["old"] = moved("/library")
    assert connection(server).get(Wanted("old", 1000)) == b"an index"
    for elsewhere in ("http://127.0.0.1:1/library", "https://evil.example/", "file:///etc/passwd", "//evil.example/x"):
        server.answers["old"] = moved(elsewhere)
        assert key(server, "old") == "store.sent_elsewhere"
    server.answers["old"] = moved("/old")
    assert key(server, "old") == "store.sent_around"


def test_a_password_is_sent_where_it_is_wanted_and_nobody_listens(tmp_path):  # R-F03
    (tmp_path / "library").write_bytes(b"an index")
    with LibraryServer(tmp_path, password="ann:secret") as server:
        assert key(server) == "store.password_needed"
        wrong = connection(server, credential=Credential("guess", "ann"))
        for _ in range(10):
            reply = wrong.get(Wanted("library", 1000))
            assert isinstance(reply, Reason) and reply.key == "store.password_wrong"
            assert "guess" not in str(reply)
        assert connection(server, credential=Credential("secret", "ann")).get(Wanted("library", 1000)) == b"an index"


def test_plain_text_carries_no_password(tmp_path, monkeypatch):  # R-F03
    (tmp_path / "library").write_bytes(b"an index")
    with LibraryServer(tmp_path, password="ann:secret") as server:
        monkeypatch.setattr(WebAddress, "keeps_secrets", False)
        reply = connection(server, credential=Credential("secret", "ann")).get(Wanted("library", 1000))
        assert isinstance(reply, Reason) and reply.key == "store.password_unsafe"
