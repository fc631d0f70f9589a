from dataclasses import replace

import pytest

from onika.link.caller import Role
from onika.web.access.page_sessions import IDLE_NS, LONGEST_NS, OF_ONE, PageSessions
from onika.web.access.page_users import PageUser
from onika.web.access.password_hash import PasswordHash

ANN = PageUser("ann", Role.OPERATOR, PasswordHash(b"s" * 16, b"d" * 32))
USERS = {"ann": ANN}


@pytest.fixture
def sessions():
    return PageSessions()


def test_a_token_is_its_users_and_no_other_is(sessions):  # R-F10
    token = sessions.open(ANN, "10.0.0.1", 0)
    visitor = sessions.visitor(token, 1)
    assert (visitor.user, visitor.role, visitor.address) == ("ann", Role.OPERATOR, "10.0.0.1")
    assert token not in repr(visitor)
    for other in ("", token[:-1], token + "A", visitor.session):
        assert sessions.visitor(other, 1) is None


def test_each_sign_in_has_a_token_that_nobody_knew_before(sessions):  # session fixation
    assert sessions.open(ANN, "", 0) != sessions.open(ANN, "", 0)


@pytest.mark.parametrize(("steps", "is_there"), [([IDLE_NS - 1], True), ([IDLE_NS], False), ([IDLE_NS - 1] * 13, True)])
def test_without_use_it_ends(sessions, steps, is_there):  # R-F10
    token, now = sessions.open(ANN, "", 0), 0
    for step in steps:
        now += step
        visitor = sessions.visitor(token, now)
    assert (visitor is not None) is is_there


def test_it_ends_after_a_week_however_much_it_is_used(sessions):  # R-F10
    token = sessions.open(ANN, "", 0)
    name = sessions.visitor(token, 0).session
    for now in range(0, LONGEST_NS, IDLE_NS // 2):
        assert sessions.sweep(USERS, (name,), now) == ()
    (over,) = sessions.sweep(USERS, (name,), LONGEST_NS)
    assert (over.user, over.session) == ("ann", name)
    assert len(sessions) == 0


@pytest.mark.parametrize(
    "users", [{}, {"ann": replace(ANN, role=Role.VIEWER)}, {"ann": replace(ANN, password=PasswordHash(b"t" * 16, b""))}]
)
def test_whoever_is_no_more_what_he_was_is_out(sessions, users):  # R-F10
    token = sessions.open(ANN, "", 0)
    assert len(sessions.sweep(users, (), 1)) == 1
    assert sessions.visitor(token, 1) is None


def test_one_that_is_closed_is_replayed_in_vain(sessions):  # R-F10
    token = sessions.open(ANN, "", 0)
    sessions.close(sessions.visitor(token, 0).session)
    assert sessions.visitor(token, 0) is None


def test_a_user_has_so_many_at_most_and_others_keep_theirs(sessions):
    other = sessions.open(replace(ANN, name="bob"), "", 0)
    tokens = [sessions.open(ANN, "", number) for number in range(OF_ONE + 3)]
    there = [sessions.visitor(token, 100) is not None for token in tokens]
    assert there == [False] * 3 + [True] * OF_ONE
    assert sessions.visitor(other, 100) is not None
