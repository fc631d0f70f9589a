import asyncio

import pytest
from msgspec import json

from kit.labs.kept_library import KeptLibrary, hash_of
from kit.labs.library_site import wink
from onika.agent import library_door
from onika.agent.door import application
from onika.host.sessions.admission import Admission
from onika.host.sessions.users import User, Users
from onika.link.caller import Role
from onika.link.token import digest
from onika.wire.library_change import (
    ChangeAnswer,
    ChangedFile,
    ChangedMeanwhile,
    ChangeRefused,
    ChangeTaken,
    LibraryChange,
)

RMOD = "module/wink.rmod"
USERS = (User("ann", Role.PROGRAMMER, digest("anns")), User("eve", Role.VIEWER, digest("eves")))


class Asking:
    """Asks the application as a server would."""

    def __init__(self, kept):
        admission = Admission(Users(USERS), ("robot",), is_private=False)
        self.app = application(admission, None, lambda: 0, kept.keeper)

    def __call__(self, method, path, token="anns", body=b"", **more):
        """Status and body of the answer."""
        headers = {"host": "robot:7995", "authorization": f"Bearer {token}", **more}
        scope = {
            "type": "http", "method": method, "path": path, "query_string": b"",
            "headers": [(name.encode(), value.encode()) for name, value in headers.items()], "client": ("10.0.0.7", 1),
        }  # fmt: skip
        heard, parts = [], [body[at : at + 65536] for at in range(0, len(body), 65536)] or [b""]

        async def receive():
            return {"type": "http.request", "body": parts.pop(0), "more_body": bool(parts)}

        async def send(message):
            heard.append(message)

        asyncio.run(self.app(scope, receive, send))
        return heard[0]["status"], b"".join(part.get("body", b"") for part in heard[1:])


@pytest.fixture
def kept(tmp_path):
    with KeptLibrary(tmp_path) as kept:
        yield kept


@pytest.fixture
def ask(kept):
    return Asking(kept)


def change(before, after):
    return json.encode(LibraryChange("wings", (ChangedFile(RMOD, hash_of(before), after.encode()),)))


def test_who_has_a_token_reads_the_library(ask, kept):  # R-F03
    index = (kept.site.folder / "library").read_bytes()
    assert ask("GET", "/library/library", "eves") == (200, index)
    code = next((kept.site.folder / "objects").iterdir())
    assert ask("GET", f"/library/objects/{code.name}", "eves") == (200, code.read_bytes())


def test_a_piece_of_the_library_is_answered_as_such(ask, kept):  # R-F03
    index = (kept.site.folder / "library").read_bytes()
    assert ask("GET", "/library/library", range="bytes=10-19") == (206, index[10:20])
    assert ask("GET", "/library/library", range=f"bytes=10-{len(index) + 5}") == (206, index[10:])


@pytest.mark.parametrize(("asked", "status"), [("bytes=9999999-99999999", 416), ("bytes=5-4", 416)])
def test_a_piece_that_is_not_there_is_refused(ask, asked, status):  # R-F03
    assert ask("GET", "/library/library", range=asked) == (status, b"")


@pytest.mark.parametrize("asked", ["bytes=0-1,4-5", "bytes=-5", "bytes=5-", "lines=0-1", "bytes=0-1\n", "bytes=٣-٤"])
def test_what_is_asked_for_in_another_way_is_the_whole(ask, kept, asked):  # R-F03
    assert ask("GET", "/library/library", range=asked) == (200, (kept.site.folder / "library").read_bytes())


@pytest.mark.parametrize(
    ("method", "path", "token", "status"),
    [
        ("GET", "/library/library", "wrong", 401),
        ("POST", "/library/changes", "wrong", 401),
        ("GET", "/library/objects/" + "0" * 64, "anns", 404),
        ("GET", "/library/objects/..%2f..%2fkey", "anns", 404),
        ("GET", "/library/objects/library", "anns", 404),
        ("GET", "/library/changes", "anns", 405),
        ("PUT", "/library/library", "anns", 405),
    ],
)
def test_nothing_else_is_given_away(ask, method, path, token, status):  # R-F03
    assert ask(method, path, token)[0] == status


def test_changes_are_taken_told_or_refused(ask, kept):  # R-F03
    def sent(body, token="anns"):
        status, answer = ask("POST", "/library/changes", token, body)
        return status, json.decode(answer, type=ChangeAnswer)

    assert sent(change(wink(), wink(says="blinks"))) == (200, ChangeTaken("wings", 2))
    status, answer = sent(change(wink(), wink(says="glows")))
    assert status == 409 and isinstance(answer, ChangedMeanwhile)
    status, answer = sent(change(wink(), wink(says="glows")), "eves")
    assert status == 403 and isinstance(answer, ChangeRefused)
    assert kept.text(RMOD) == wink(says="blinks")


def test_what_is_no_change_or_too_much_is_refused(ask, kept, monkeypatch):  # R-F03
    for body in (b"", b"{}", b"[" * 50_000, b'{"library": 7, "files": []}'):
        assert ask("POST", "/library/changes", body=body)[0] == 400
    monkeypatch.setattr(library_door, "LARGEST", 100_000)
    assert ask("POST", "/library/changes", body=b" " * 200_000)[0] == 413
    assert ask("POST", "/library/changes", body=b" ", **{"content-length": "999999999"})[0] == 413
    assert kept.text(RMOD) == wink()
