import asyncio
import ssl
from types import SimpleNamespace

import pytest

from onika.desk.environment.environment import ActAnswer
from onika.files import trail
from onika.link.caller import Role
from onika.web import guarded_door
from onika.web.access.entrance import Visitor
from onika.web.access.page_place import PagePlace
from onika.web.access.page_users import PageUser, PageUserFile
from onika.web.access.password_hash import PasswordHash
from onika.web.guarded_door import TRAIL, GuardedDoor
from onika.web.server import bound
from onika.wire import act

PASSWORD = "correct horse battery"


class Pages:
    """The hub, as far as the door knows it."""

    def __init__(self):
        self.denials, self.ended = [], []
        self.sessions = frozenset()

    def end(self, session):
        self.ended.append(session)

    def visitor(self, name):
        return Visitor("ann", Role.OWNER, "s", "10.0.0.1") if name == "ann 1" else None


@pytest.fixture
def door(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path))
    monkeypatch.setattr(guarded_door, "_LOOK_S", 0.001)
    users = PageUserFile(tmp_path / "users")
    users.put(PageUser("ann", Role.OWNER, PasswordHash.of(PASSWORD, 15, 1)))
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    place = PagePlace("127.0.0.1", 0, context, "", users.path, ("localhost",))
    environment, hub, told = SimpleNamespace(observers=[], say=print), Pages(), []
    with bound(0) as listening:
        door = GuardedDoor(place, listening, told.append, environment, hub)
        door.told, door.hub, door.observers, door.users = told, hub, environment.observers, users
        door.lines = lambda: trail.read([tmp_path / "onika" / "audit" / TRAIL]).records
        yield door
    door.close()


def test_it_says_where_it_is_and_writes_that_down(door):  # R-F10
    door.ready()
    assert door.told[0].startswith("https://localhost:")  # for which its certificate is
    assert [line["what"] for line in door.lines()] == ["PageOpened"]
    assert isinstance(door.context, ssl.SSLContext)


def test_what_users_do_is_written_down_and_what_is_no_users_is_not(door):  # R-X12
    (observe,) = door.observers
    observe(act.Reset(), "ann 1")(ActAnswer())
    observe(act.Reset(), "Onika")(ActAnswer())
    (denial,) = door.hub.denials
    denial(Visitor("wil", Role.VIEWER), act.Save("c1"))
    assert [(line["what"], line["who"]) for line in door.lines()] == [("Reset", "ann"), ("Save", "wil")]


def test_a_session_of_a_user_who_is_gone_ends_with_its_pages(door):  # R-F10
    async def removed():
        token, _ = await door.entrance.enter("ann", PASSWORD, "10.0.0.1")
        session = door.entrance.visitor({door.entrance.cookie_name: token}).session
        door.users.remove("ann")
        keeping = asyncio.ensure_future(door.keep())
        while not door.hub.ended:
            await asyncio.sleep(0)
        keeping.cancel()
        return session

    assert door.hub.ended == [asyncio.run(removed())]
