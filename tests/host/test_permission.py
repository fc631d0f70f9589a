import pytest

from onika.host.permission import brings_code, refusal
from onika.link.caller import Caller, Role
from onika.wire import live, request
from onika.wire.plan import Code, Plan

CODE = Code("d", "m", "m.py", "x = 1")
LOOKS = [
    request.Stop("x"), request.Snapshot(), live.Survey(), live.Read("s"), live.Status(), live.Check("s"),
    live.Attend(), live.Scene("w"),
]  # fmt: skip
WITH_CODE = [
    request.Prepare(Plan("a", (), (CODE,)), ()),
    request.Inspect((), (CODE,)),
    live.Describe((CODE,)),
    live.Change("s", code=(CODE,)),
    live.Swap("s", "t", CODE),
]
COMMANDS = [
    request.Begin(), request.Abort("x"), request.Reply("s", "t", ""), request.Prepare(Plan("a", (), ()), ()),
    live.Change("s"), live.Take("s"), live.Release("s"), live.Set("s", "t", "n", "1"), live.Reset(), live.Close("s"),
    live.Touch("w", "panic", 1.0),
]  # fmt: skip
LEAST = [(Role.VIEWER, LOOKS), (Role.OPERATOR, COMMANDS), (Role.PROGRAMMER, WITH_CODE), (Role.OWNER, [request.Quit()])]


def caller(role, near=True):
    return Caller("ann", role, "192.0.2.7", near)


@pytest.mark.parametrize("role", Role)
def test_a_role_may_what_it_and_those_before_it_may(role):  # law 27
    for least, requests in LEAST:
        for asked in requests:
            assert (refusal(caller(role), asked, True) == "") is (role >= least), (role, asked)


def test_everybody_may_stop():  # law 27
    assert all(refusal(caller(role, near), request.Stop("x"), False) == "" for role in Role for near in (True, False))


@pytest.mark.parametrize("asked", WITH_CODE)
def test_code_from_elsewhere_has_to_be_accepted(asked):  # law 23
    assert brings_code(asked)
    assert "--accept-code" in refusal(caller(Role.OWNER, near=False), asked, False)
    assert refusal(caller(Role.OWNER, near=False), asked, True) == ""
    assert refusal(caller(Role.OWNER, near=True), asked, False) == ""
