import asyncio

import pytest
from msgspec import json

from onika.classroom.front import ClassFront
from onika.classroom.room import ClassRoom
from onika.link import refusal_header

from .test_room import Grader, Seat

HOST = "127.0.0.1:8430"
OWN = {"origin": f"http://{HOST}"}
FORM = {**OWN, "content-type": "application/x-www-form-urlencoded"}


class Front:
    """The front of a class, asked as a server would."""

    def __init__(self, folder):
        self.room = ClassRoom(folder / "class", 2, lambda learner: learner.name, Grader(), 100, Seat)
        static = folder / "board"
        static.mkdir()
        (static / "board.js").write_text("")
        self.keys, self.time = [], 0
        self.front = ClassFront(
            self.room, ("127.0.0.1",), 8430, static, on_key=self.keys.append, clock=lambda: self.time
        )
        self.app = self.front.application()

    def __call__(self, method, path, body=b"", cookie="", host=HOST, **more):
        """Status, headers and body of the answer."""
        path, _, query = path.partition("?")
        headers = {"host": host, "cookie": cookie, **more}
        scope = {
            "type": "http", "method": method, "path": path, "query_string": query.encode(), "client": ("10.0.0.7", 1),
            "headers": [(name.encode(), value.encode()) for name, value in headers.items()],
        }  # fmt: skip
        heard = []

        async def receive():
            return {"type": "http.request", "body": body, "more_body": False}

        async def send(message):
            heard.append(message)

        asyncio.run(self.app(scope, receive, send))
        answered = {name.decode(): value.decode() for name, value in heard[0]["headers"]}
        return heard[0]["status"], answered, b"".join(message.get("body", b"") for message in heard[1:])

    def join(self, name, code=None):
        code = self.room.roster.code if code is None else code
        status, headers, body = self("POST", "/join", f"code={code}&name={name}".encode(), **FORM)
        return status, headers.get("set-cookie", "").partition(";")[0], body

    def teacher(self):
        _, headers, _ = self("GET", f"/board?key={self.front.login.key}")
        return headers["set-cookie"].partition(";")[0]


@pytest.fixture
def front(tmp_path):
    return Front(tmp_path)


def why(headers):
    return refusal_header.read(headers[refusal_header.HEADER.lower()]).key


def test_whoever_knows_the_code_gets_a_seat_and_the_way_to_it(front):  # R-X25
    status, cookie, _ = front.join("Ana")
    assert (status, cookie.startswith("onika-class-8430=")) == (303, True)
    assert b"Ana, seat 1" in front("GET", "/", cookie=cookie)[2]
    status, headers, _ = front("GET", "/seat", cookie=cookie)
    assert (status, headers["location"].partition("?key=")[0]) == (303, "http://127.0.0.1:9000/enter")


@pytest.mark.parametrize(("name", "code", "status"), [("Ana", "WRONG", 401), ("", None, 409), ("..", None, 409)])
def test_whoever_does_not_is_told_and_gets_none(front, name, code, status):  # R-X25
    got, cookie, body = front.join(name, code)
    assert (got, cookie, b'role="alert"' in body) == (status, "", True)
    assert front.room.roster.learners == ()


def test_who_guesses_codes_waits(front):  # R-X25
    assert [front.join("Ana", "WRONG")[0] for _ in range(11)] == [401] * 10 + [429]
    assert front.join("Ana")[0] == 429
    front.time = 3600 * 1_000_000_000
    assert front.join("Ana")[0] == 303


def test_without_a_seat_there_is_no_way_to_one(front):
    front.join("Ana")
    assert front("GET", "/seat")[1]["location"] == "/"
    assert front("GET", "/seat", cookie="onika-class-8430=guess")[1]["location"] == "/"


BOARD = [("GET", "/board"), ("GET", "/board/state"), ("POST", "/board/act"), ("GET", "/board/watch/1")]


@pytest.mark.parametrize(("method", "path"), BOARD)
def test_the_board_is_for_whoever_has_its_key_no_learner(front, method, path):  # R-X25
    _, cookie, _ = front.join("Ana")
    for given in ("", cookie, "onika-board-8430=guess"):
        status, headers, _ = front(method, path, b'{"act":"freeze","seats":[1]}', cookie=given, **OWN)
        assert (status, why(headers)) == (403, "class.board_without_key")
    assert front.room.roster.at(1).state == "works"


def test_the_key_of_the_board_lets_one_browser_in(front):
    key = front.front.login.key
    assert front.teacher()
    assert front("GET", f"/board?key={key}")[0] == 403
    assert front.keys == [front.front.login.key]


def test_the_teacher_sees_all_and_does_with_seats_what_he_wants(front):  # R-X25
    for name in ("Ana", "Ben"):
        front.join(name)
    cookie = front.teacher()
    wishes = [
        ("freeze", [1], ""),
        ("take", [2], ""),
        ("tell", [1, 2], "look"),
        ("return", [2], ""),
        ("restart", [1], ""),
    ]
    for wish, seats, text in wishes:
        body = json.encode({"act": wish, "seats": seats, "text": text})
        assert front("POST", "/board/act", body, cookie=cookie, **OWN)[0] == 204
    rows = json.decode(front("GET", "/board/state", cookie=cookie)[2])["rows"]
    assert [(row["learner"], row["state"], row["note"], row["may_return"]) for row in rows] == [
        ("Ana", "frozen", "look", False),
        ("Ben", "taken", "look", True),
    ]
    assert front("GET", "/board/watch/2", cookie=cookie)[1]["location"].startswith("http://127.0.0.1:9000/enter?key=")
    assert front("GET", "/board/watch/9", cookie=cookie)[0] == 503


@pytest.mark.parametrize("body", [b"", b"{}", b'{"act":"format","seats":[]}', b"x" * 5000])
def test_what_is_no_wish_of_a_board_is_refused(front, body):
    assert front("POST", "/board/act", body, cookie=front.teacher(), **OWN)[0] == 400


def test_pages_of_others_send_nothing_and_other_names_lead_nowhere(front):  # R-X25
    cookie = front.teacher()
    for origin in ("http://evil.example", "http://127.0.0.1:9000", "null"):
        status, headers, _ = front("POST", "/board/act", b"{}", cookie=cookie, origin=origin)
        assert (status, why(headers)) == (403, "desk.foreign_page")
    for host in ("evil.example:8430", "127.0.0.1:9000", "a b"):
        assert front("GET", "/", host=host)[0] == 421


def test_what_is_not_there_is_told(front):
    assert front("GET", "/nothing")[0] == 404
    assert front("GET", "/join")[0] == 405
    assert front("POST", "/join", b"x", **OWN)[0] == 400
