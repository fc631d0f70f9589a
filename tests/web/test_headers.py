import asyncio

from onika.web.headers import StrictHeaders


def test_an_answer_keeps_its_own_headers_and_gets_the_strict_ones():
    sent = []

    async def app(_scope, _receive, send):
        await send({"type": "http.response.start", "status": 200, "headers": [(b"x-own", b"1")]})
        await send({"type": "http.response.body", "body": b""})

    async def keep(message):
        sent.append(message)

    asyncio.run(StrictHeaders(app)({"type": "http", "path": "/"}, None, keep))
    headers = dict(sent[0]["headers"])
    assert headers[b"x-own"] == b"1"
    assert headers[b"x-frame-options"] == b"DENY"
    assert headers[b"cache-control"] == b"no-store"
