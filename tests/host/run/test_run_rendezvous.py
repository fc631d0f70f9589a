"""What the rendezvous of a run makes of what its engine, its units and the other runtime say."""

from itertools import count
from types import SimpleNamespace

import pytest

from onika.engine.news import Agreed, BegunAlone, Closed
from onika.engine.orders import Convene, Disperse, Launch, Switch
from onika.engine.rendezvous_exchange import RendezvousExchange
from onika.engine.rendezvous_terms import EVERY_NS, RendezvousTerms
from onika.host.run.run_rendezvous import RunRendezvous
from onika.ring.begin_words import BeginWords
from onika.runtime import command, news
from onika.wire.rendezvous import Phase

MS = 1_000_000
TERMS = RendezvousTerms(MS, MS)
RUN, EPOCHS, TAGS = bytes(16), {0: 70, 1: 71}, [(0, 1)]
ORDERED = Switch(0, (), (Launch("grip"),))
CARRIED = command.Switch("flow0", (), (), (command.Launch("grip", activation=3),))


class Line:
    """A channel whose other end is an exchange in the hands of the test."""

    def __init__(self):
        self.exchange = RendezvousExchange(RUN, 0, EPOCHS, TAGS, TERMS)
        self.other = RendezvousExchange(RUN, 1, EPOCHS, TAGS, TERMS)
        self.count = count(1)
        self.is_cut = False

    def receive(self, now):
        if self.is_cut:
            return []
        return self.exchange.hear(next(self.count), self.other.report(0, now), now)

    def look(self, now):
        return [*self.exchange.look(now), *self.other.look(now)][: 0 if self.is_cut else None]

    def speak(self, now):
        if not self.is_cut:
            self.other.hear(next(self.count), self.exchange.report(1, now), now)

    def due_ns(self):
        return 7

    def fileno(self):
        return 5


class Rig:
    """The rendezvous, two units, and everything that is said to engine and units."""

    def __init__(self, homes=("rt0",)):
        self.line, self.fed, self.sent, self.ready = Line(), [], [], {}
        self.words = {"rt0": BeginWords(), "rt1": BeginWords()}
        self.now = 10**9
        self.meeting = RunRendezvous(self.line, ["x"], {1: "B"}, TERMS, self, count(1))
        members = {f"task{number}": SimpleNamespace(rtpu=home) for number, home in enumerate(homes)}
        group = ("rt0", CARRIED) if homes == ("rt0",) else None
        executor = SimpleNamespace(name="flow0", members=members, appoint=lambda switch: group)
        self.meeting.attach({0: executor}, self, self.fed.append)

    def begin_words(self, rtpu):
        return self.words[rtpu]

    def send(self, rtpu, order):
        self.sent.append((rtpu, order))

    def appointed(self, number, switches):
        self.ready[number] = switches

    def serve(self, times=1):
        for _ in range(times):
            self.now += EVERY_NS // 2
            self.meeting.serve(self.now)

    def convene(self, **given):
        self.meeting.order(Convene("x", (0,), (ORDERED,), **given))

    def agree(self):
        """Both come; they are permitted to begin."""
        self.line.other.meetings[0].come(self.now)
        self.convene()
        self.serve(2)
        appointment = self.sent[-1][1]
        self.now = appointment.at_ns - TERMS.commit_ns
        self.meeting.serve(self.now)
        self.serve()
        self.now = appointment.at_ns
        return appointment

    def appoint(self, has_begun=True, number=1, rtpu="rt0"):
        self.meeting.hear(rtpu, news.Appointed(number, self.now, has_begun), self.now)


@pytest.fixture
def rig():
    return Rig()


def test_units_are_told_to_begin_at_the_time_that_is_agreed(rig):  # law 34
    appointment = rig.agree()
    assert rig.sent == [("rt0", appointment)]
    assert appointment == command.Appointment(1, appointment.at_ns, TERMS.alone_ns, ("flow0",), (CARRIED,))
    assert rig.words["rt0"].is_permitted(1)
    assert (rig.meeting.shared, rig.meeting.fileno()) == ({"x"}, 5)


def test_the_engine_learns_that_its_flows_have_begun_and_then_that_all_have(rig):  # R-F02
    rig.agree()
    rig.appoint()
    assert (rig.fed, rig.ready) == ([Agreed("x", 1)], {1: {0: CARRIED}})
    rig.line.other.meetings[0].begun(1, rig.now)
    rig.serve()
    assert rig.fed[1:] == [Closed("x")]
    assert rig.words["rt0"].is_confirmed(1)


def test_who_has_begun_alone_is_told_with_the_names_of_the_others(rig):  # R-F02
    rig.agree()
    rig.line.is_cut = True
    rig.appoint()
    rig.meeting.hear("rt0", news.HeldAlone(1, rig.now), rig.now)
    assert isinstance(rig.fed[-1], BegunAlone)
    assert str(rig.fed[-1].cause).endswith("B; recover to meet again")
    assert not rig.words["rt0"].is_confirmed(1)
    rig.meeting.hear("rt0", news.HeldAlone(1, rig.now), rig.now)
    assert len(rig.fed) == 2


def test_what_another_has_not_begun_is_held_at_once(rig):
    rig.agree()
    rig.appoint()
    rig.line.other.meetings[0].missed(1, rig.now)
    rig.serve()
    assert rig.sent[-1] == ("rt0", command.CallOff(1, holds=True))
    assert isinstance(rig.fed[-1], BegunAlone)


def test_what_begins_alone_and_drives_nothing_may_meet_again_unasked(rig):  # R-F02, decision 56
    rig.agree()
    rig.meeting.hear("rt0", news.Appointed(1, rig.now, has_begun=True, drives=False), rig.now)
    rig.line.other.meetings[0].missed(1, rig.now)
    rig.serve()
    assert (rig.fed[-1].drives, rig.fed[-1].cause.key) == (False, "host.meets_again")


@pytest.mark.parametrize("driving", ["rt0", "rt1"])
def test_where_one_unit_drives_something_a_user_decides(driving):  # law 34
    rig = Rig(("rt0", "rt1"))
    rig.agree()
    for rtpu in ("rt0", "rt1"):
        rig.meeting.hear(rtpu, news.Appointed(1, rig.now, has_begun=True, drives=rtpu == driving), rig.now)
    rig.line.other.meetings[0].missed(1, rig.now)
    rig.serve()
    assert (rig.fed[-1].drives, rig.fed[-1].cause.key) == (True, "host.began_alone")


def test_what_was_not_begun_is_not_told_to_the_engine(rig):
    rig.agree()
    rig.appoint(has_begun=False)
    assert rig.fed == []
    assert rig.line.exchange.meetings[0].state.phase is Phase.WAIT
    rig.appoint(number=99)


def test_flows_on_two_units_begin_by_both_and_are_switched_by_the_program():
    rig = Rig(("rt0", "rt1"))
    rig.agree()
    assert [(rtpu, order.switches) for rtpu, order in rig.sent] == [("rt0", ()), ("rt1", ())]
    rig.appoint(rtpu="rt0")
    assert rig.fed == []
    rig.appoint(rtpu="rt1")
    assert rig.fed == [Agreed("x", 0)]


def test_where_one_of_two_units_has_not_begun_the_other_is_held():
    rig = Rig(("rt0", "rt1"))
    rig.agree()
    rig.appoint(rtpu="rt0")
    rig.appoint(rtpu="rt1", has_begun=False)
    assert rig.sent[-1] == ("rt0", command.CallOff(1, holds=True))
    assert rig.fed == []


def test_who_is_about_to_begin_is_not_steered(rig):  # R-E13
    rig.convene()
    rig.serve()
    assert not rig.meeting.refusal("flow0")
    rig = Rig()
    rig.agree()
    assert "about to begin" in str(rig.meeting.refusal("flow0"))
    assert not rig.meeting.refusal("flow7")


@pytest.mark.parametrize(("was_there", "phase"), [(False, Phase.AWAY), (True, Phase.MET)])
def test_who_is_sent_elsewhere_is_said_to_be_gone_or_to_have_been_there(rig, was_there, phase):  # R-E13
    rig.convene()
    rig.serve()
    assert rig.meeting.due_ns() == 7
    rig.meeting.order(Disperse("x", was_there))
    assert rig.meeting.due_ns() == 0
    rig.serve()
    assert rig.line.exchange.meetings[0].state.phase is phase


def test_whom_all_others_have_been_let_pass_goes_on_at_once(rig):
    rig.line.other.meetings[0].come(rig.now)
    rig.line.other.meetings[0].let_pass(rig.now)
    rig.convene()
    rig.serve(2)
    assert rig.fed == [Agreed("x"), Closed("x")]


def test_what_was_held_repeats_its_step_where_all_had_begun(rig):  # R-E08
    rig.agree()
    rig.appoint()
    rig.meeting.hear("rt0", news.HeldAlone(1, rig.now), rig.now)
    rig.line.other.meetings[0].begun(1, rig.now)
    rig.serve()
    rig.convene(anew=True)
    rig.serve()
    assert rig.fed[-2:] == [Agreed("x"), Closed("x")]
    rig.convene(anew=True)
    rig.serve()
    assert rig.fed[-2:] == [Agreed("x"), Closed("x")]
