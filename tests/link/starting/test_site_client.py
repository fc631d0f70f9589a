import socket
import threading

import pytest
from msgspec import json

from onika.link import refusal_header
from onika.link.lost import LinkLost, LossCause
from onika.link.starting import site_client as room
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_client import SiteClient
from onika.wire.site_card import LaunchCard, SiteCard, SiteHandOver
from onika.words.reason import Reason

CARD = SiteCard("cmu", "a" * 32, 1.0, "ann", "operator", (LaunchCard("arm"),))
HANDED = SiteHandOver("cmu", "a" * 32, "arm", 7000, True, True)


def answer(body=b"", status="200 OK", *headers):
    head = "\r\n".join((f"HTTP/1.1 {status}", f"Content-Length: {len(body)}", *headers))
    return f"{head}\r\n\r\n".encode() + body


class BenchDoor:
    """Answers connections one after the other with these bytes, and keeps what each asked."""

    def __init__(self, *answers):
        self.listener = socket.create_server(("127.0.0.1", 0))
        self.questions = []
        self.is_over = threading.Event()
        self.thread = threading.Thread(target=self.serve, args=(answers,), daemon=True)
        self.thread.start()

    def client(self, name="arm", stays=False):
        port = self.listener.getsockname()[1]
        return SiteClient(SiteAddress("127.0.0.1", port, name, stays, is_private=False), "s3cret")

    def serve(self, answers):
        for given in answers:
            connected, _ = self.listener.accept()
            with connected:
                self.questions.append(connected.recv(4096))
                if given is None:
                    self.is_over.wait(10.0)
                else:
                    connected.sendall(given)

    def close(self):
        self.is_over.set()
        self.thread.join(10.0)
        self.listener.close()


@pytest.fixture
def door():
    made = []

    def at(*answers):
        made.append(BenchDoor(*answers))
        return made[-1]

    yield at
    for each in made:
        each.close()


def lost(do):
    with pytest.raises(LinkLost) as why:
        do()
    assert "s3cret" not in str(why.value)
    return why.value


def test_a_site_is_asked_with_a_token_and_nothing_else(door):  # R-A15
    there = door(answer(json.encode(CARD)), answer(json.encode(HANDED)), answer(b"null"))
    client = there.client(stays=True)
    assert client.card() == CARD
    assert client.launch() == HANDED
    client.end()
    firsts = [question.split(b"\r\n")[0] for question in there.questions]
    assert firsts == [b"GET /card HTTP/1.1", b"POST /launch/arm?stay HTTP/1.1", b"POST /end/arm HTTP/1.1"]
    assert all(b"Authorization: Bearer s3cret\r\n" in question for question in there.questions)


@pytest.mark.parametrize(
    ("status", "cause"),
    [
        ("401 No", LossCause.TOKEN),
        ("403 No", LossCause.FORBIDDEN),
        ("429 No", LossCause.FORBIDDEN),
        ("409 No", LossCause.REFUSED),
        ("502 No", LossCause.REFUSED),
    ],
)
def test_why_a_site_refuses_is_told_in_its_words(door, status, cause):  # R-A15
    why = Reason.of("site.does_not_run", name="arm")
    header = f"{refusal_header.HEADER}: {refusal_header.written(why)}"
    refusal = lost(door(answer(b"no", status, header)).client().launch)
    assert refusal.cause is cause and refusal.reason.args["why"] == why


@pytest.mark.parametrize(
    "given",
    [answer(b"<html>"), answer(b"", "302 Found"), answer(b'{"onika":"launched"}'), answer(b"[" * 5000), b"SSH-2.0\r\n"],
)
def test_what_is_no_site_is_told(door, given):  # R-A15
    assert lost(door(given).client().card).cause in (LossCause.GARBAGE, LossCause.REFUSED, LossCause.UNREACHABLE)


def test_a_site_that_says_too_much_is_not_read_on(door, monkeypatch):
    monkeypatch.setattr(room, "_LARGEST", 100)
    assert lost(door(answer(b"x" * 200)).client().card).cause is LossCause.GARBAGE


def test_a_site_that_says_nothing_is_waited_for_no_longer_than_said(door, monkeypatch):  # R-A15
    monkeypatch.setattr(room, "ANSWER_S", 0.2)
    silent = lost(door(None).client().card)
    assert silent.cause is LossCause.TIMEOUT and "within 0.2 s" in str(silent)


def test_where_nobody_is_that_is_told(door):
    there = door()
    client = there.client()
    there.close()
    assert lost(client.card).cause is LossCause.UNREACHABLE
