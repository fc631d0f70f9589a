import pytest

from kit.plans.plan_builder import action
from kit.worlds.rail_world import rail_tasks
from onika.host.sessions.audit_log import AuditLog
from onika.host.sessions.request_server import SessionRequest
from onika.link.caller import Caller, Role
from onika.link.channel import Channel
from onika.link.sessions import Introduction
from onika.wire import event, holding, live, request, steer
from onika.words.reason import NOTHING, Reason

PLAN = rail_tasks().plan([action("mass", "servo", arguments="1")])
TASK, CODE = PLAN.flows[0].tasks[0], PLAN.code[0]


class Book:
    def __init__(self):
        self.trouble = ""
        self.lines = []

    def note(self, what, weighs=False, **about):
        self.lines.append((what, weighs, {key: value for key, value in about.items() if value}))


@pytest.fixture
def book():
    return Book()


def answered(book, wish, response=None, complain=lambda _text: None):
    AuditLog(book, complain).answered(
        SessionRequest(1, "ann#2", Role.OPERATOR, wish, "192.0.2.7"), response or request.Done()
    )


def test_a_command_is_one_line_with_who_from_where_what_and_what_came_of_it(book):  # R-X12
    answered(book, live.Set("s0", "arm", "gain", "2"), request.Refused(Reason.plain("held by bob#3")))
    who = {"who": "ann#2", "role": "operator", "address": "192.0.2.7", "on": "s0"}
    about = {"about": "task=arm name=gain value=2", "result": "refused: held by bob#3"}
    assert book.lines == [("Set", False, who | about)]


COMMANDS = [
    live.Change("s0", on=(live.Turn("arm", "1"),)),
    live.Clear("s0", "a"),
    live.Reinit("s0", "a"),
    live.Set("s", "t", "n", "1"),
    live.Close("s0"),
    live.Take("s0"),
    live.Release("s0"),
    live.Touch("w", "panic", 1.0),
    live.Reset(),
    holding.OnlyWatch(),
    holding.Hand("s0", "bob"),
    holding.Decline("s0"),
    request.Begin(),
    request.Reply("s0", "a", "1"),
    request.Abort(Reason.plain("x")),
    request.Stop(Reason.plain("x")),
    request.Quit(),
    request.Prepare(PLAN, ()),
    steer.Pause(),
    steer.Resume(),
    steer.Step(),
    live.Swap("s0", "a", CODE),
]
LOOKS = [
    live.Survey(),
    live.Read("s0"),
    live.Status(),
    live.Attend(),
    holding.Sessions(),
    steer.Who(),
    live.Advance(1.0),
]


@pytest.mark.parametrize("wish", COMMANDS, ids=lambda wish: type(wish).__name__)
def test_there_is_no_command_without_a_line(book, wish):  # R-X12
    answered(book, wish)
    assert [line[0] for line in book.lines] == [type(wish).__name__]


@pytest.mark.parametrize("wish", LOOKS, ids=lambda wish: type(wish).__name__)
def test_looking_is_no_command(book, wish):
    answered(book, wish)
    assert book.lines == []


def test_code_is_named_by_its_whole_digest_and_goes_to_the_disk_at_once(book):  # R-X12
    answered(book, live.Change("s0", spawn=(TASK,), code=(CODE,)), live.Accepted(3))
    ((_, weighs, about),) = book.lines
    assert weighs
    assert (about["code"], about["about"], about["result"]) == ([CODE.digest], f"spawn={TASK.name}", "accepted as 3")
    answered(book, live.Describe((CODE,)))
    assert book.lines[1][:2] == ("Describe", True)


def test_stops_and_changes_of_holder_go_to_the_disk_at_once(book):  # R-X12
    answered(book, request.Stop(Reason.plain("x")))
    audit_log = AuditLog(book)
    for message in (
        event.Held("s0", "bob#3", Reason.plain("why")),
        event.Stopped(True, Reason.plain("x")),
        event.Stopped(False, NOTHING),
    ):
        audit_log.told(message)
    assert [line[:2] for line in book.lines] == [
        ("Stop", True),
        ("held", True),
        ("stopped", True),
        ("may move again", True),
    ]
    assert book.lines[1][2] == {"on": "s0", "who": "bob#3", "result": "why"}


def test_how_what_was_accepted_ended_is_a_line_too(book):  # R-X12
    audit_log = AuditLog(book)
    audit_log.told(event.Edited("s0", 3, Reason.plain("it is gone"), 1.0))
    audit_log.told(event.Edited("s0", 4, NOTHING, 1.0))
    audit_log.told(event.TaskState("s0", "arm", "ON", 1.0))
    assert [line[2]["result"] for line in book.lines] == ["it is gone", "done"]


def test_who_comes_and_goes_is_a_line_once_and_not_for_each_connection(book):  # R-X12
    audit_log = AuditLog(book)
    caller = Caller("ann", Role.VIEWER, "192.0.2.7", False)
    for channel in (Channel.SESSION, Channel.SIGNAL, Channel.STREAM):
        audit_log.came(Introduction(channel, "c", "", caller), NOTHING)
    audit_log.came(Introduction(Channel.ALL, "c", "", caller), Reason.of("link.sessions_full", count=32))
    audit_log.lost("ann#2")
    audit_log.garbage("ann#2", "no request")
    results = [(what, about.get("result")) for what, _, about in book.lines]
    assert results[:2] == [("connect", "connected"), ("connect", "refused: there are 32 sessions already")]
    assert [what for what, _ in results[2:]] == ["gone", "garbage"]


def test_that_it_cannot_be_written_is_told_once_until_it_can_again(book):  # R-X12
    lines = []
    audit_log = AuditLog(book, lines.append)
    for trouble in ("full", "full", "", "full"):
        book.trouble = trouble
        audit_log.told(event.Held("s0", "bob#3"))
    assert lines == ["full", "full"]


def test_of_pushes_those_leave_a_line_that_take_the_pad_press_its_button_or_let_go(book):  # R-X12, R-K07
    log = AuditLog(book)
    held, free = live.Push((0.5,) * 6, is_held=True), live.Push((0.0,) * 6, is_held=False)
    pressed = live.Push((0.0,) * 6, is_held=False, button=True)
    no = request.Refused(Reason.plain("no"))
    for push, answer in [(free, request.Done())] * 3 + [(held, request.Done())] * 9 + [(free, request.Done())] * 2:
        log.answered(SessionRequest(1, "ann#2", Role.OPERATOR, push, ""), answer)
    for push, answer in [(pressed, request.Done()), (pressed, request.Done()), (held, no), (held, no)]:
        log.answered(SessionRequest(1, "ann#2", Role.OPERATOR, push, ""), answer)
    told = [(about.get("about"), about["result"]) for _, _, about in book.lines]
    assert told == [("held", "done"), ("let go", "done"), ("button", "done"), ("held", "refused: no")]
