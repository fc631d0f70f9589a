"""The page over TLS attacked from outside: without a cookie, with another's, from foreign pages, by floods (R-F10)."""

import http.client
import json
import re
import socket
import ssl
from urllib.parse import urlencode

import pytest
from websockets.exceptions import ConnectionClosed
from websockets.sync.client import connect

from onika.link import refusal_header
from onika.wire import request

pytestmark = pytest.mark.site

PASSWORD = "correct horse battery"
FORM = "application/x-www-form-urlencoded"


def ask(served, method, path, body=None, cookie="", **headers):
    link = http.client.HTTPSConnection(served.address, timeout=60, context=served.trusted)
    told = {"Host": served.address, **({"Cookie": cookie} if cookie else {}), **headers}
    link.request(method, path, body, {name: value for name, value in told.items() if value is not None})
    answer = link.getresponse()
    text = answer.read().decode()
    link.close()
    return answer, text


def post(served, path="/sign-in", name="own", password=PASSWORD, cookie="", **headers):
    told = {"Origin": f"https://{served.address}", "Content-Type": FORM, **headers}
    return ask(served, "POST", path, urlencode({"name": name, "password": password}), cookie, **told)


def cookie(served, name="own", before=""):
    answer, _ = post(served, name=name, cookie=before)
    assert answer.status == 303
    return answer.headers["set-cookie"].partition(";")[0]


def talk(served, given):
    origin = f"https://{served.address}"
    return connect(
        f"wss://{served.address}/ws", additional_headers={"Cookie": given}, origin=origin, ssl=served.trusted
    )


def turned_away(served, given, origin):
    """The status by which a WebSocket is refused."""
    upgrade = {"Connection": "Upgrade", "Upgrade": "websocket", "Sec-WebSocket-Version": "13"}
    upgrade |= {"Sec-WebSocket-Key": "AAAAAAAAAAAAAAAAAAAAAA==", "Origin": origin}
    return ask(served, "GET", "/ws", cookie=given, **upgrade)[0].status


def first(socket):
    return json.loads(socket.recv(timeout=60))


def answered(socket, **act):
    socket.send(json.dumps({"cid": 7, "act": act}))
    while (message := first(socket)).get("cid") != 7:
        pass
    return message


def test_who_signs_in_is_let_in_by_a_cookie_that_only_we_get_back(served_to_others):  # R-F10
    answer, _ = post(served_to_others)
    given = answer.headers["set-cookie"]
    assert given.startswith("__Host-onika-")
    assert {"HttpOnly", "Secure", "SameSite=strict", "Path=/"} <= set(given.split("; "))
    assert "Domain" not in given
    answer, text = ask(served_to_others, "GET", "/", cookie=given.partition(";")[0])
    assert (answer.status, "<title>Onika" in text) == (200, True)
    with talk(served_to_others, given.partition(";")[0]) as page:
        told = first(page)
        assert (told["t"], told["user"], told["role"]) == ("Snapshot", "own", "owner")


def test_who_has_no_cookie_is_asked_to_sign_in_and_told_nothing_else(served_to_others):  # R-F10
    answer, text = ask(served_to_others, "GET", "/", **{"Accept-Language": "es"})
    assert (answer.status, answer.headers["content-language"]) == (401, "es")
    assert 'type="password"' in text
    assert "script" not in answer.headers["content-security-policy"]
    for path, status in (("/mesh/" + "0" * 32, 403), ("/?key=", 401), ("/nothing", 404)):
        assert ask(served_to_others, "GET", path)[0].status == status


@pytest.mark.parametrize("given", ["", "{name}=", "{name}=x", "{name}={other}", "onika-1=x", "{name}=" + "x" * 4000])
def test_a_cookie_that_is_none_opens_nothing(served_to_others, given):  # R-F10
    name = served_to_others.door.entrance.cookie_name
    forged = given.format(name=name, other="A" * 43)
    assert ask(served_to_others, "GET", "/", cookie=forged)[0].status == 401
    assert turned_away(served_to_others, forged, f"https://{served_to_others.address}") == 403


@pytest.mark.parametrize("origin", ["https://evil.example", "http://{address}", "null", "https://localhost", None])
def test_a_foreign_page_signs_nobody_in_or_out_and_talks_to_nobody(served_to_others, origin):  # CSRF
    origin = origin and origin.format(address=served_to_others.address)
    given = cookie(served_to_others)
    for path in ("/sign-in", "/sign-out"):
        answer, _ = post(served_to_others, path, cookie=given, Origin=origin)
        assert refusal_header.read(answer.headers[refusal_header.HEADER]).key == "desk.foreign_page"
        assert "set-cookie" not in answer.headers
    assert ask(served_to_others, "GET", "/", cookie=given)[0].status == 200
    assert turned_away(served_to_others, given, origin) == 403


def test_another_name_of_ours_is_refused(served_to_others):  # DNS rebinding
    given = cookie(served_to_others)
    assert ask(served_to_others, "GET", "/", cookie=given, Host="evil.example")[0].status == 421
    answer, _ = post(served_to_others, Host="evil.example", Origin="https://evil.example")
    assert (answer.status, "set-cookie" in answer.headers) == (421, False)


def test_a_session_that_somebody_brings_along_is_not_taken_over(served_to_others):  # session fixation
    name = served_to_others.door.entrance.cookie_name
    planted = f"{name}=" + "A" * 43
    mine = cookie(served_to_others, before=planted)
    assert mine != planted
    assert ask(served_to_others, "GET", "/", cookie=planted)[0].status == 401
    again = cookie(served_to_others, before=mine)
    assert ask(served_to_others, "GET", "/", cookie=mine)[0].status == 401  # whoever had seen the former one is out
    assert ask(served_to_others, "GET", "/", cookie=again)[0].status == 200


def test_after_signing_out_the_cookie_is_void_and_open_pages_close(served_to_others):  # replay
    given = cookie(served_to_others)
    with talk(served_to_others, given) as page:
        assert first(page)["t"] == "Snapshot"
        answer, _ = post(served_to_others, "/sign-out", cookie=given)
        assert (answer.status, "Max-Age=0" in answer.headers["set-cookie"]) == (303, True)
        with pytest.raises(ConnectionClosed):
            while True:
                page.recv(timeout=60)
    assert ask(served_to_others, "GET", "/", cookie=given)[0].status == 401
    assert ("SignOut", "own", "signed-out") in served_to_others.trail()


def test_a_user_who_is_removed_is_out_within_a_moment(served_to_others, cheap_users):  # R-F10
    viewer = cheap_users[0]
    given = cookie(served_to_others, viewer.name)
    with talk(served_to_others, given) as page:
        first(page)
        served_to_others.file.remove(viewer.name)
        with pytest.raises(ConnectionClosed):
            while True:
                page.recv(timeout=60)
    assert ask(served_to_others, "GET", "/", cookie=given)[0].status == 401
    served_to_others.file.put(viewer)


def test_a_watcher_stops_and_does_nothing_else(served_to_others):  # R-F10
    with talk(served_to_others, cookie(served_to_others, "vie")) as page:
        assert first(page)["role"] == "viewer"
        page.send('{"cid": 1, "act": {"t": "Stop"}}')
        assert answered(page, t="New")["reason"]["key"] == "desk.only_watch_and_stop"
        assert answered(page, t="Press", name="x")["t"] == "Refused"
    assert [type(order.asked) for order in served_to_others.sitting.orders] == [request.Stop]
    assert ("New", "vie", "refused:role") in served_to_others.trail()


@pytest.mark.parametrize(
    ("body", "kind"),
    [
        (b"name=own&password=" + b"x" * 5000, FORM),
        (b"a=1&" * 100, FORM),
        (b"\xff\xfe", FORM),
        (b"name=own", FORM),
        (b"name=own&name=own&password=x", FORM),
        (b'{"name":"own"}', "application/json"),
        (b"", ""),
    ],
)
def test_what_is_no_form_is_refused_and_costs_no_try(served_to_others, body, kind):  # R-X01
    headers = {"Origin": f"https://{served_to_others.address}", "Content-Type": kind}
    assert ask(served_to_others, "POST", "/sign-in", body, **headers)[0].status == 400


def raw(served):
    host, _, port = served.address.partition(":")
    plain = socket.create_connection(("127.0.0.1", int(port)), 60)
    return served.trusted.wrap_socket(plain, server_hostname=host)


@pytest.mark.parametrize(
    "request_bytes",
    [b"GET / HTTP/1.1\r\nHost: " + b"x" * 100_000, b"\x00\x01\r\n\r\n", b"GET /" + b"a" * 70_000 + b" HTTP/1.1\r\n"],
)
def test_requests_without_end_are_cut(served_to_others, request_bytes):  # R-F10
    with raw(served_to_others) as line:
        line.sendall(request_bytes)
        told = b"-"
        try:
            answer = b""
            while told:
                told = line.recv(4096)
                answer += told
        except (ConnectionError, ssl.SSLError):
            answer = b""
    assert not answer or re.match(rb"HTTP/1.1 (400|431)", answer)


def test_a_form_that_never_ends_takes_nobodys_time(served_to_others, monkeypatch):  # slow requests
    monkeypatch.setattr("onika.web.sent_form._PATIENCE_S", 0.2)
    host = served_to_others.address.encode()
    head = b"POST /sign-in HTTP/1.1\r\nHost: %s\r\nOrigin: https://%s\r\n" % (host, host)
    head += b"Content-Type: application/x-www-form-urlencoded\r\nContent-Length: 100\r\n\r\nname="
    with raw(served_to_others) as line:
        line.sendall(head)
        assert cookie(served_to_others)  # meanwhile others come in
        assert line.recv(4096).startswith(b"HTTP/1.1 400")


def test_other_ways_of_asking_are_refused(served_to_others):
    for method in ("PUT", "DELETE", "PATCH", "OPTIONS"):
        for path in ("/", "/sign-in", "/sign-out"):
            assert ask(served_to_others, method, path)[0].status == 405
    assert ask(served_to_others, "GET", "/sign-out")[0].status == 405
    assert ask(served_to_others, "GET", "/sign-in")[0].status == 303


def test_the_wrong_password_ten_times_bars_the_right_one(served_to_others):  # last: it bars this machine for a minute
    statuses = [post(served_to_others, password="wrong")[0].status for _ in range(11)]
    assert statuses == [401] * 10 + [429]
    answer, text = post(served_to_others)
    assert (answer.status, "1 minute." in text) == (429, True)
    assert "set-cookie" not in answer.headers
    assert ("SignIn", "own", "refused:too-many-tries") in served_to_others.trail()
