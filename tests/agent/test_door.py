import asyncio

import pytest
from msgspec import json

from onika.agent.door import application
from onika.agent.launches import SiteRefusal
from onika.host.sessions.admission import WRONG_TOKENS, Admission
from onika.host.sessions.users import User, Users
from onika.link import refusal_header
from onika.link.caller import Role
from onika.link.token import digest
from onika.wire.site_card import SiteCard, SiteHandOver
from onika.words.reason import Reason

CARD = SiteCard("cmu", "id", 0.0, "ann", "operator")


class Listed:
    """Keeps what was asked for."""

    def __init__(self):
        self.wishes = []

    def card(self, guest):
        return CARD

    def launch(self, name, guest, *, stays):
        self.wishes.append((name, guest.name, stays))
        if name != "arm":
            raise SiteRefusal(Reason.of("site.does_not_run", name=name), 404)
        return SiteHandOver("cmu", "id", name, 7000, True, stays)

    def end(self, name, guest):
        self.wishes.append((f"end {name}", guest.name))


class Asking:
    """Asks the application as a server would."""

    def __init__(self):
        self.listed, self.time = Listed(), 0
        admission = Admission(Users((User("ann", Role.OPERATOR, digest("anns")),)), ("robot",), is_private=False)
        self.app = application(admission, self.listed, lambda: self.time)

    def __call__(self, method, path, token="anns", host="robot:7995", **more):
        """Status, headers and body of the answer."""
        path, _, query = path.partition("?")
        headers = {"host": host, "authorization": f"Bearer {token}", **more}
        scope = {
            "type": "http", "method": method, "path": path, "query_string": query.encode(),
            "headers": [(name.encode(), value.encode()) for name, value in headers.items()], "client": ("10.0.0.7", 1),
        }  # fmt: skip
        heard = []

        async def receive():
            return {"type": "http.request", "body": b"", "more_body": False}

        async def send(message):
            heard.append(message)

        asyncio.run(self.app(scope, receive, send))
        names = {name.decode(): value.decode() for name, value in heard[0]["headers"]}
        return heard[0]["status"], names, b"".join(part.get("body", b"") for part in heard[1:])


@pytest.fixture
def ask():
    return Asking()


def test_three_verbs_are_answered(ask):  # R-A15
    assert json.decode(ask("GET", "/card")[2], type=SiteCard) == CARD
    assert json.decode(ask("POST", "/launch/arm?stay")[2], type=SiteHandOver).stays
    assert ask("POST", "/end/arm")[0] == 200
    assert ask.listed.wishes == [("arm", "ann", True), ("end arm", "ann")]


@pytest.mark.parametrize(
    ("method", "path", "status"),
    [("GET", "/", 404), ("POST", "/launch/arm/sh", 404), ("GET", "/launch/arm", 405), ("PUT", "/card", 405)],
)
def test_there_is_no_other_request(ask, method, path, status):  # R-A15 R-X12
    answered, headers, body = ask(method, path)
    assert answered == status and b"expected GET /card" in body
    assert refusal_header.read(headers[refusal_header.HEADER.lower()]).key == "site.no_such_path"
    assert ask.listed.wishes == []


def test_what_is_refused_says_why(ask):  # R-A15
    status, headers, _ = ask("POST", "/launch/crane")
    assert status == 404
    assert refusal_header.read(headers[refusal_header.HEADER.lower()]).args == {"name": "crane"}


def test_a_wrong_token_ten_times_is_told_to_wait_and_the_right_one_is_still_let_in(ask):  # R-X12
    assert [ask("POST", "/launch/arm", "guess")[0] for _ in range(WRONG_TOKENS)] == [401] * WRONG_TOKENS
    assert ask("GET", "/card", "guess")[0] == 429
    assert ask("GET", "/card")[0] == 200
    assert ask.listed.wishes == []


def test_a_foreign_name_and_a_foreign_page_are_turned_away(ask):  # R-X12
    assert ask("GET", "/card", host="evil.example")[0] == 403
    assert ask("POST", "/launch/arm", origin="http://evil.example")[0] == 403
    assert ask.listed.wishes == []
