import asyncio

import pytest
from starlette.requests import Request

from onika.web.sent_form import sent_body, sent_form

FORM = "application/x-www-form-urlencoded"


def request(*pieces, kind=FORM, breaks_off=False):
    """A request whose body comes in pieces."""
    more = [{"type": "http.request", "body": piece, "more_body": True} for piece in pieces]
    last = {"type": "http.disconnect"} if breaks_off else {"type": "http.request", "body": b"", "more_body": False}
    messages = iter((*more, last))

    async def receive():
        return next(messages)

    headers = [(b"content-type", kind.encode())]
    return Request({"type": "http", "method": "POST", "path": "/", "query_string": b"", "headers": headers}, receive)


def read(sent, *names):
    return asyncio.run(sent_form(sent, *(names or ("code", "name"))))


def test_the_fields_of_a_form_come_in_the_order_in_which_they_are_asked_for():  # R-F10
    assert read(request(b"name=Ana%20B", b"&code=ABC")) == ("ABC", "Ana B")
    assert read(request(b"name=&code=ABC", kind=f"{FORM}; charset=utf-8")) == ("ABC", "")
    assert read(request(b"code=%C3%B1&name=x")) == ("ñ", "x")


@pytest.mark.parametrize(
    "body",
    [b"", b"code=A", b"code=A&name=B&name=C", b"code", b"code=\xff&name=x", b"code=%ff&name=x", b"a=1&b=2&c=3&d=4&e=5"],
)
def test_what_is_no_such_form_is_none(body):  # R-F10
    assert read(request(body)) is None


def test_what_is_of_another_kind_too_large_or_broken_off_is_none():  # R-F10
    assert read(request(b"code=A&name=B", kind="text/plain")) is None
    assert read(request(*[b"x" * 1000] * 5)) is None
    assert read(request(b"code=A&name=B", breaks_off=True)) is None
    assert asyncio.run(sent_body(request(b"{}", kind="application/json"))) == b"{}"
    assert asyncio.run(sent_body(request(*[b"x" * 1000] * 5))) is None
