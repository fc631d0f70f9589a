import pytest

from kit.labs.module_source import COUNTER
from kit.plans.plan_builder import PlanBuilder
from onika.host.sessions.permission import brings_code, changes_nothing, refusal
from onika.link.caller import PARENT, Caller, Role
from onika.wire import booking, holding, live, request, steer
from onika.wire.foresight import WhatIf
from onika.wire.plan import Code, Plan
from onika.wire.samples import Sample
from onika.wire.world_source import WorldSource
from onika.words.reason import NOTHING, Reason

CODE = Code("d", "m", "m.py", "x = 1")
LOOKS = [
    request.Stop(Reason.plain("x")), request.Snapshot(), live.Survey(), live.Read("s"), live.Status(), live.Check("s"),
    live.Attend(), live.Scene("w"), live.ListWorlds(), steer.Who(), WhatIf(),
    Sample(("s/X",)), holding.Sessions(), holding.OnlyWatch(), booking.Bookings(),
]  # fmt: skip
WITH_CODE = [
    request.Prepare(Plan("a", (), (CODE,)), ()),
    request.Inspect((), (CODE,)),
    live.Describe((CODE,)),
    live.Solve(CODE, (), ()),
    live.Change("s", code=(CODE,)),
    live.Swap("s", "t", CODE),
    live.Reinit("s", "t", (("GAIN", ("1",)), ("STARTS", ("rm", "-r")))),
    live.Reinit("s", "t", (("PARTNER", ("tcp:192.0.2.1:80",)),)),
]
COMMANDS = [
    request.Begin(), request.Abort(Reason.plain("x")), request.Reply("s", "t", ""),
    request.Prepare(Plan("a", (), ()), ()),
    live.Change("s"), live.Take("s"), live.Release("s"), live.Set("s", "t", "n", "1"), live.Reset(), live.Close("s"),
    live.Write("s", "X", (1.0,)),
    live.Touch("w", "panic", 1.0), live.Reinit("s", "t", (("GAIN", ("1",)),)), live.AddUnit("rt2"),
    holding.Hand("s", "ann"), holding.Decline("s"),
]  # fmt: skip
OWN = [request.Quit(), holding.Listen("127.0.0.1:0"), holding.StopListening()]
LEAST = [(Role.VIEWER, LOOKS), (Role.OPERATOR, COMMANDS), (Role.PROGRAMMER, WITH_CODE), (Role.OWNER, OWN)]


def caller(role, near=True):
    return Caller("ann", role, "192.0.2.7", near)


@pytest.mark.parametrize("role", Role)
def test_a_role_may_what_it_and_those_before_it_may(role):  # law 27
    for least, requests in LEAST:
        for message in requests:
            assert (refusal(caller(role), message, True) == NOTHING) is (role >= least), (role, message)


@pytest.mark.parametrize(
    ("key", "role", "message", "least"),
    [
        ("host.role_wanted_an", Role.VIEWER, request.Abort(Reason.plain("x")), Role.OPERATOR),
        ("host.role_wanted_an", Role.OPERATOR, request.Quit(), Role.OWNER),
    ],
)
def test_who_may_not_is_told_which_role_may(key, role, message, least):  # law 27
    what = type(message).__name__
    expected = Reason.of(key, least=least.word, what=what, user="ann", role=role.word)
    assert refusal(caller(role), message, True) == expected


def test_who_may_not_bring_code_is_told_who_may():  # law 27
    expected = Reason.of("host.role_for_code", least="programmer", user="ann", role="operator")
    assert refusal(caller(Role.OPERATOR), live.Swap("s", "t", CODE), True) == expected


def test_only_the_program_that_launched_the_runtime_makes_recordings():  # X05: a file on that machine
    beginning = request.Begin(record="/tmp/run.mcap")
    assert not refusal(PARENT, beginning, False)
    refused = refusal(Caller("ann", Role.OWNER, "127.0.0.1", True), beginning, True)
    assert refused == Reason.of("host.recording_of_launcher", user="ann")


def test_a_recording_by_hand_is_a_file_on_that_machine_too():  # R-X05
    recording = live.Record("s0", "/tmp/run.mcap")
    assert not refusal(PARENT, recording, False)
    refused = refusal(Caller("ann", Role.OWNER, "127.0.0.1", True), recording, True)
    assert refused == Reason.of("host.recording_of_launcher", user="ann")


def test_worlds_as_files_are_as_good_as_code():  # R-X19, law 23
    files = (WorldSource("yard", "abc", ()),)
    assert brings_code(request.Inspect((), (), files))
    assert brings_code(live.Change("s", worlds=files))
    assert not brings_code(request.Inspect((), ()))


def test_everybody_may_stop():  # law 27
    assert all(
        not refusal(caller(role, near), request.Stop(Reason.plain("x")), False)
        for role in Role
        for near in (True, False)
    )


@pytest.mark.parametrize("wish", WITH_CODE)
def test_code_from_elsewhere_has_to_be_accepted(wish):  # law 23
    assert brings_code(wish)
    assert refusal(caller(Role.OWNER, near=False), wish, False) == Reason.of("host.code_from_afar", address="192.0.2.7")
    assert not refusal(caller(Role.OWNER, near=False), wish, True)
    assert not refusal(caller(Role.OWNER, near=True), wish, False)


def test_a_task_that_starts_a_program_is_as_good_as_code_though_its_module_is_known():  # R-F04, law 23
    shop = PlanBuilder()
    plain, starts = (shop.task("t", COUNTER, local=local) for local in ({}, {"STARTS": "rm -r /"}))
    assert not brings_code(live.Change("s", spawn=(plain,)))
    assert not brings_code(live.Reinit("s", "t"))
    assert brings_code(live.Change("s", spawn=(plain, starts)))
    assert (
        "--accept-code" in refusal(caller(Role.PROGRAMMER, near=False), live.Change("s", spawn=(starts,)), False).text
    )


def test_who_looks_or_stops_changes_nothing():  # R-X12
    assert all(changes_nothing(look) for look in LOOKS)
    assert not any(changes_nothing(command) for command in COMMANDS)


def test_what_is_to_be_repeated_is_asked_in_his_name_who_begins_it():  # law 27, law 29
    swap = request.Recorded(1, 0, request.encode(live.Change("s", code=(CODE,))))
    pause = request.Recorded(1, 0, request.encode(steer.Pause()))
    begin = request.Begin(repeat=(pause, swap))
    assert refusal(caller(Role.OPERATOR), begin, True).key == "host.role_for_code"
    assert refusal(caller(Role.PROGRAMMER, near=False), begin, False).key == "host.code_from_afar"
    assert not refusal(caller(Role.PROGRAMMER), begin, False)
    assert not refusal(caller(Role.PROGRAMMER, near=False), begin, True)
    assert not refusal(caller(Role.OPERATOR), request.Begin(repeat=(pause,)), False)
