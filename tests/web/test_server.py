import asyncio
import http.client
import socket

import pytest

from onika.web.server import addresses, bound, until_first_ends


def test_only_this_machine_reaches_the_port():  # R-X11
    with bound(0) as listening:
        host, port = listening.getsockname()
        assert host == "127.0.0.1"
        assert addresses(listening) == (f"127.0.0.1:{port}", f"localhost:{port}")


def test_no_answer_is_held_back_for_the_next():
    with bound(0) as listening:
        assert listening.proto == socket.IPPROTO_TCP  # else asyncio leaves Nagle's delay of 40 ms on


def test_a_port_that_is_taken_is_said():
    with bound(0) as listening:
        listening.listen()
        with pytest.raises(OSError, match="in use"):
            bound(listening.getsockname()[1])


@pytest.mark.site
def test_what_runs_beside_ends_the_server(served):
    link = http.client.HTTPConnection(served.address, timeout=60)
    link.request("GET", "/")
    assert link.getresponse().status in (403, 421)
    link.close()
    served.__exit__()
    with pytest.raises(OSError):
        http.client.HTTPConnection(served.address, timeout=1).request("GET", "/")


def test_the_first_that_ends_ends_the_others_and_they_may_finish():
    seen = []

    async def long():
        try:
            await asyncio.Event().wait()
        finally:
            await asyncio.sleep(0)
            seen.append("finished")

    asyncio.run(until_first_ends([long(), asyncio.sleep(0)]))
    assert seen == ["finished"]


def test_what_one_of_them_raises_is_raised():
    async def wrong():
        raise ValueError("as it was")

    with pytest.raises(ValueError, match="as it was"):
        asyncio.run(until_first_ends([asyncio.Event().wait(), wrong()]))
