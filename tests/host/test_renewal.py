from types import SimpleNamespace

import pytest

from onika.host.renewal import refusal
from onika.wire.holding import SessionStanding

ME = SessionStanding("me", "owner")


def reason(runs=(), live=(), sessions=(ME,), *, is_virtual=True, is_waiting=False):
    subsystems = SimpleNamespace(runs=[SimpleNamespace(application=name) for name in runs], live=dict.fromkeys(live))
    return refusal("me", subsystems, sessions, is_virtual=is_virtual, is_waiting=is_waiting)


def test_where_nothing_lives_and_nobody_else_is_there_a_runtime_may_be_renewed():  # R-X23
    assert not reason()
    assert not reason(sessions=())


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ({"is_virtual": False}, "in wall time nothing is made anew"),
        ({"runs": ("assemble",)}, "assemble runs"),
        ({"live": ("s1", "s0")}, "tasks live in s0"),
        ({"sessions": (ME, SessionStanding("you", "viewer"))}, "you is connected too"),
        ({"is_waiting": True}, "still being looked for"),
    ],
)
def test_what_speaks_against_it_is_said(what, words):  # R-X23
    assert words in str(reason(**what))
