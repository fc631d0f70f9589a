import http.client
import json

import pytest
from websockets.exceptions import ConnectionClosed, InvalidStatus
from websockets.sync.client import connect

from onika.link import refusal_header
from onika.words.reason import Reason, in_language

pytestmark = pytest.mark.site


def get(served, path="/", **headers):
    link = http.client.HTTPConnection(served.address, timeout=60)
    link.request("GET", path, headers={"Host": served.address, **headers})
    answer = link.getresponse()
    body = answer.read().decode()
    link.close()
    return answer, body


def cookie(served):
    answer, _ = get(served, f"/?key={served.login.key}")
    assert answer.status == 303
    return answer.headers["set-cookie"].partition(";")[0]


def talk(served, given=None, origin=None):
    headers = {"Cookie": given} if given else {}
    return connect(f"ws://{served.address}/ws", additional_headers=headers, origin=origin or f"http://{served.address}")


def test_the_key_gives_a_cookie_that_scripts_cannot_read_and_the_page(served):
    answer, _ = get(served, f"/?key={served.login.key}")
    given = answer.headers["set-cookie"]
    assert "HttpOnly" in given
    assert "SameSite=strict" in given
    answer, body = get(served, Cookie=given.partition(";")[0])
    assert (answer.status, "Onika" in body) == (200, True)


@pytest.mark.parametrize("path", ["/", "/?key=wrong"])
def test_without_the_key_there_is_no_page(served, path):
    answer, body = get(served, path)
    assert answer.status == 403
    assert "address that Onika printed" in body


REFUSALS = [
    ("/", {}, 403, "desk.page_without_key"),
    ("/", {"Host": "evil.example"}, 421, "desk.no_such_host"),
    ("/nothing", {}, 404, "desk.no_such_page"),
    ("/assets/nothing.js", {}, 404, "desk.no_such_page"),
]


@pytest.mark.parametrize(("path", "headers", "status", "key"), REFUSALS)
def test_a_refusal_speaks_the_language_of_the_browser_and_names_its_key(served, path, headers, status, key):  # R-G03
    answer, body = get(served, path, **{"Accept-Language": "fr;q=0.9, es-MX;q=0.8, en;q=0.1", **headers})
    assert (answer.status, answer.headers["content-language"]) == (status, "es")
    reason = refusal_header.read(answer.headers[refusal_header.HEADER])
    assert reason == Reason.of(key)
    assert body == f"{in_language(reason, 'es')}\n"


def test_a_page_is_only_read(served):
    link = http.client.HTTPConnection(served.address, timeout=60)
    link.request("POST", "/", headers={"Host": served.address})
    answer = link.getresponse()
    assert refusal_header.read(answer.headers[refusal_header.HEADER]) == Reason.of("desk.only_read")
    assert answer.status == 405
    link.close()


def test_a_page_under_a_foreign_name_is_refused(served):  # DNS rebinding
    answer, _ = get(served, f"/?key={served.login.key}", Host="evil.example")
    assert answer.status == 421


def test_every_answer_is_strict(served):
    for path in ("/", "/assets/page.js", "/nothing"):
        answer, _ = get(served, path)
        policy = answer.headers["content-security-policy"]
        assert "default-src 'none'" in policy
        assert "script-src 'self';" in policy
        assert "frame-ancestors 'none'" in policy
        assert answer.headers["x-content-type-options"] == "nosniff"
        assert answer.headers["referrer-policy"] == "no-referrer"


def test_files_are_kept_by_the_browser_and_the_page_is_not(served):
    assert "immutable" in get(served, "/assets/page.js")[0].headers["cache-control"]
    assert get(served, Cookie=cookie(served))[0].headers["cache-control"] == "no-store"


@pytest.mark.parametrize("path", ["/assets/../../secret", "/assets/%2e%2e/%2e%2e/secret", "//etc/passwd"])
def test_nothing_outside_the_page_is_given(served, path):
    assert get(served, path, Cookie=cookie(served))[0].status in (403, 404)


def test_acts_are_answered_over_the_socket(served):
    with talk(served, cookie(served)) as socket:
        assert json.loads(socket.recv())["t"] == "Snapshot"
        socket.send('{"cid": 3, "act": {"t": "New"}}')
        message = json.loads(socket.recv())
        while message["t"] == "Patch":
            message = json.loads(socket.recv())
        assert (message["t"], message["cid"]) == ("Ok", 3)


@pytest.mark.parametrize("body", ["nonsense", '{"cid":1,"act":{"t":"Nothing"}}', b"\x00\x01"])
def test_a_wrong_message_is_refused_and_its_connection_stays(served, body):  # R-F01
    given = cookie(served)
    with talk(served, given) as socket:
        socket.recv()
        socket.send(body)
        socket.send('{"cid": 1, "act": {"t": "New"}}')
        kinds = []
        while "Ok" not in kinds:
            kinds.append(json.loads(socket.recv(timeout=60))["t"])
    assert "Refused" in kinds


def test_a_foreign_page_or_a_stranger_may_not_talk(served):
    given = cookie(served)
    for who in ({"given": None}, {"given": "onika=x"}, {"given": given, "origin": "http://evil.example"}):
        with pytest.raises((InvalidStatus, ConnectionClosed)), talk(served, **who) as socket:
            socket.recv(timeout=60)
    assert served.sitting.environment.tree.people == 0
