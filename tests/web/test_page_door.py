import asyncio

from onika.web.page_door import KeyDoor
from onika.web.server import bound


def test_the_door_of_this_machine_tells_an_address_for_each_browser():  # R-X11
    told = []
    with bound(0) as listening:
        door = KeyDoor(listening, told.append)
        door.ready()
        port = listening.getsockname()[1]
        assert told == [f"http://127.0.0.1:{port}/?key={door.entrance.key}"]
        door.entrance.enter(door.entrance.key)
        assert told[1:] == [f"http://127.0.0.1:{port}/?key={door.entrance.key}"]
        door.close()
    assert door.context is None


def test_it_has_nothing_to_do_and_does_not_end():
    async def kept():
        with bound(0) as listening:
            keeping = asyncio.ensure_future(KeyDoor(listening, print).keep())
            await asyncio.wait((keeping,), timeout=0.01)
            return keeping.done() or keeping.cancel()

    assert asyncio.run(kept())
