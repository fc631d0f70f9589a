import asyncio

import pytest

from onika.link.caller import Role
from onika.web.access.page_sessions import IDLE_NS
from onika.web.access.page_users import PageUser, PageUserFile
from onika.web.access.password_hash import PasswordHash
from onika.web.access.sign_in import SignIn
from onika.web.access.wrong_tries import BACK_OFF_NS, MOST

PASSWORD = "correct horse battery"


class Trail:
    """What would be written down."""

    def __init__(self):
        self.lines = []

    def entered(self, visitor):
        self.lines.append(("in", visitor.user))

    def turned_away(self, name, address, why):
        self.lines.append(("away", name, why))

    def left(self, visitor, why):
        self.lines.append(("out", visitor.user, why))


@pytest.fixture
def entrance(tmp_path, monkeypatch):
    kept = PasswordHash.of(PASSWORD, 4, 1)
    monkeypatch.setattr("onika.web.access.sign_in.NOBODY", PasswordHash(b"s" * 16, b"d" * 32, 4, 1))
    users = PageUserFile(tmp_path / "users")
    users.users = {name: PageUser(name, Role.OPERATOR, kept) for name in ("ann", "bob")}
    users.look = lambda: False
    entrance = SignIn(("Robot.example", "localhost"), 8420, users, Trail(), lambda: entrance.now)
    entrance.now, entrance.users, entrance.trail = 0, users, entrance._trail
    yield entrance
    entrance.close()


def enter(entrance, name="ann", password=PASSWORD, address="10.0.0.1"):
    token, reason = asyncio.run(entrance.enter(name, password, address))
    return token, reason.key


def test_a_name_and_its_password_give_a_session(entrance):  # R-F10
    token, _ = enter(entrance)
    visitor = entrance.visitor({entrance.cookie_name: token})
    assert (visitor.user, visitor.role) == ("ann", Role.OPERATOR)
    assert entrance.trail.lines == [("in", "ann")]
    assert entrance.cookie_name == "__Host-onika-8420"
    for cookies in ({}, {"onika-8420": token}, {entrance.cookie_name: ""}, {entrance.cookie_name: token[1:]}):
        assert entrance.visitor(cookies) is None


@pytest.mark.parametrize(("name", "password"), [("ann", "wrong"), ("nobody", PASSWORD), ("", ""), ("ANN", PASSWORD)])
def test_the_wrong_name_and_the_wrong_password_sound_the_same(entrance, name, password):  # R-F10
    assert enter(entrance, name, password) == ("", "desk.sign_in_wrong")
    assert entrance.trail.lines == [("away", name if name == "ann" else "", "wrong-password")]


def test_after_ten_wrong_ones_the_right_one_has_to_wait_and_other_addresses_have_not(entrance):  # R-F10
    for _ in range(MOST):
        enter(entrance, password="wrong")
    assert enter(entrance) == ("", "desk.sign_in_wait")
    assert enter(entrance, address="10.0.0.2")[0]
    entrance.now += BACK_OFF_NS
    assert enter(entrance)[0]


def test_who_has_an_account_does_not_guess_anothers_by_it(entrance):  # R-F10
    for _ in range(MOST):
        enter(entrance, "bob", "wrong")
        enter(entrance, "ann")
    assert enter(entrance, "bob") == ("", "desk.sign_in_wait")


def test_many_tries_at_a_time_are_no_more_than_ten(entrance):  # R-F10
    async def crowd():
        tries = [entrance.enter("ann", "wrong", f"10.0.0.{number}") for number in range(40)]
        return [reason.key for _, reason in await asyncio.gather(*tries)]

    answers = asyncio.run(crowd())
    assert answers.count("desk.sign_in_wrong") == 8
    assert answers.count("desk.sign_in_busy") == 32

    async def parallel():
        tries = [entrance.enter("ann", "wrong", "10.9.9.9") for _ in range(8)]
        return await asyncio.gather(*tries)

    asyncio.run(parallel())
    for _ in range(2):
        enter(entrance, "ann", "wrong", "10.9.9.9")
    assert enter(entrance, address="10.9.9.9") == ("", "desk.sign_in_wait")


def test_whoever_is_removed_while_his_password_is_looked_at_does_not_come_in(entrance):
    async def removed():
        entering = asyncio.ensure_future(entrance.enter("ann", PASSWORD, "10.0.0.1"))
        await asyncio.sleep(0)
        entrance.users.users = {}
        return await entering

    assert asyncio.run(removed())[0] == ""


def test_who_leaves_is_out_and_his_cookie_is_of_no_use(entrance):  # R-F10
    token, _ = enter(entrance)
    cookies = {entrance.cookie_name: token}
    entrance.leave(entrance.visitor(cookies))
    assert entrance.visitor(cookies) is None
    assert entrance.trail.lines[-1] == ("out", "ann", "signed-out")


def test_sessions_that_are_over_end_and_that_is_written_down(entrance):  # R-F10
    token, _ = enter(entrance)
    enter(entrance, "bob")
    session = entrance.visitor({entrance.cookie_name: token}).session
    entrance.now = IDLE_NS
    assert len(entrance.sweep((session,))) == 1
    assert entrance.trail.lines[-1] == ("out", "bob", "over")
    entrance.users.users = {}
    assert entrance.sweep((session,)) == (session,)
    assert entrance.trail.lines[-1] == ("out", "ann", "no-user-any-more")


@pytest.mark.parametrize(
    ("host", "is_ours"),
    [
        ("robot.example:8420", True),
        ("ROBOT.EXAMPLE", True),
        ("localhost:1", True),
        ("10.1.2.3:8420", True),
        ("[2001:db8::1]:8420", True),
        ("evil.example:8420", False),
        ("", False),
        ("a@robot.example", False),
        ("robot.example/x", False),
        ("robot.example.evil.example", False),
    ],
)
def test_only_our_names_and_numbers_are_ours(entrance, host, is_ours):  # DNS rebinding
    assert entrance.is_ours({"host": host}) is is_ours


@pytest.mark.parametrize(
    ("host", "origin", "is_own"),
    [
        ("robot.example:8420", "https://robot.example:8420", True),
        ("robot.example:8420", "http://robot.example:8420", False),
        ("robot.example:8420", "https://robot.example", False),
        ("robot.example:8420", "https://evil.example", False),
        ("robot.example:8420", "null", False),
        ("robot.example:8420", "", False),
        ("evil.example", "https://evil.example", False),
    ],
)
def test_only_a_page_that_came_from_here_may_send(entrance, host, origin, is_own):  # R-F10
    assert entrance.is_own_page({"host": host, "origin": origin}) is is_own
    assert not entrance.is_own_page({"host": host})
