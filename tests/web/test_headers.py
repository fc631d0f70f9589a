import asyncio

import pytest

from onika.web.headers import StrictHeaders


def headers_of(path, status=200):
    """The headers of an answer that has one of its own."""
    sent = []

    async def app(_scope, _receive, send):
        await send({"type": "http.response.start", "status": status, "headers": [(b"x-own", b"1")]})
        await send({"type": "http.response.body", "body": b""})

    async def keep(message):
        sent.append(message)

    asyncio.run(StrictHeaders(app)({"type": "http", "path": path}, None, keep))
    return dict(sent[0]["headers"])


def test_an_answer_keeps_its_own_headers_and_gets_the_strict_ones():
    headers = headers_of("/")
    assert headers[b"x-own"] == b"1"
    assert headers[b"x-frame-options"] == b"DENY"
    assert headers[b"cache-control"] == b"no-store"


@pytest.mark.parametrize(
    ("path", "status", "is_kept"),
    [("/assets/a.js", 200, True), ("/mesh/12", 200, True), ("/mesh/12", 404, False), ("/mesh/12", 403, False)],
)
def test_what_is_named_by_its_content_is_kept_for_ever_where_it_is_there(path, status, is_kept):  # R-X19
    assert (b"immutable" in headers_of(path, status)[b"cache-control"]) is is_kept
