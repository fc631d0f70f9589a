"""Who holds what, by itself: what the control authority answers, tells and does, with nothing that runs (law 27)."""

from inspect import getgeneratorlocals
from types import SimpleNamespace

import pytest

from onika.host.sessions.control_authority import ControlAuthority
from onika.wire import event, holding, live, request, steer
from onika.wire.plan import Code
from onika.words.reason import NOTHING, Reason

CODE = Code("d", "m", "m.py", "x = 1")
MINUTE_NS = 60_000_000_000


class Live:
    """A subsystem by hand; notes what is begun in it."""

    def __init__(self, holder="", *members):
        self.holder = holder
        self.members = dict.fromkeys(members)
        self.begun = []

    @property
    def is_empty(self):
        return not self.members

    def begin(self, number, transaction):
        self.begun.append((number, getgeneratorlocals(transaction)["live"] is self))
        transaction.close()


class Run:
    """A run of an application; notes why it was abandoned."""

    def __init__(self, session, *names, application="work", on_loss="stop"):
        self.session, self.names, self.application, self.on_loss = session, names, application, on_loss
        self.abandoned = []

    def abandon(self, cause, now):
        self.abandoned.append((cause, now))


class Subsystems:
    """Those of a runtime."""

    def __init__(self):
        self.live = {}
        self.runs = []
        self.released = []
        self.hold = SimpleNamespace(release=self.released.append)

    def run_in(self, name):
        return next((run for run in self.runs if name in run.names), None)

    def by_hand(self, name):
        return self.live.setdefault(name, Live())

    def drop(self, name):
        del self.live[name]


class Bench:
    """A control authority among fakes, and what it tells."""

    def __init__(self):
        self.subsystems = Subsystems()
        self.told = []
        self.standings = [holding.SessionStanding(name, "operator") for name in ("one", "two", "ann#1", "ann#2")]
        steering = SimpleNamespace(refusal=lambda session, message: Reason.plain(f"{session}: {message!r}"))
        self.authority = ControlAuthority(
            self.subsystems, lambda *told: self.told.append(told), steering, lambda: self.standings
        )

    def refusal(self, session, message, is_stopped=False):
        return self.authority.refusal(session, message, is_stopped)

    def take(self, session, name="s0"):
        return self.authority.change(session, live.Take(name))

    def release(self, session, name="s0"):
        return self.authority.change(session, live.Release(name))

    def hand(self, session, to, name="s0", wall_ns=0):
        return self.authority.hand(session, holding.Hand(name, to), wall_ns)

    def runs(self, *given, **settings):
        run = Run(*given, **settings)
        self.subsystems.runs.append(run)
        return run

    def keys(self):
        """What was told since the last time: of which subsystem, to whom, and why."""
        told = [(name, session, _key(message)) for message, name, session in self.told]
        self.told.clear()
        return told


def _key(message):
    reason = message.cause if isinstance(message, event.Held) else message.outcome
    return reason.key if isinstance(reason, Reason) else reason


@pytest.fixture
def bench():
    return Bench()


CHANGES = [
    live.Change("s0", off=("t",)), live.Clear("s0", "t"), live.Reinit("s0", "t"), live.Swap("s0", "t", CODE),
    live.Set("s0", "t", "X", "1"), live.Close("s0"), live.Release("s0"), request.Reply("s0", "t", "1"),
]  # fmt: skip
LATE = [change for change in CHANGES if not isinstance(change, live.Release)]


def named(message):
    return type(message).__name__


@pytest.mark.parametrize("message", CHANGES, ids=named)
def test_what_changes_a_subsystem_is_for_its_holder_alone(bench, message):  # R-X12
    assert bench.refusal("two", message) == NOTHING
    bench.take("one")
    assert bench.refusal("one", message) == NOTHING
    assert bench.refusal("two", message) == Reason.of("host.held_stop", subsystem="s0", holder="one")


@pytest.mark.parametrize("message", [*LATE, steer.Pause(), holding.Hand("s0", "two")], ids=named)
def test_what_may_have_been_meant_before_the_silence_moves_nothing_after_it(bench, message):  # R-X12
    bench.take("one")
    bench.authority.lapse("one", 250_000_000, 7)
    assert bench.refusal("one", message).key == "host.holder_lapsed"
    assert bench.refusal("two", message).key != "host.holder_lapsed"
    bench.authority.began("one")
    assert bench.refusal("one", message).key != "host.holder_lapsed"


def test_who_was_silent_may_give_back_look_and_take_anew(bench):  # R-X12
    bench.authority.lapse("one", 250_000_000, 7)
    assert bench.refusal("one", live.Release("s0")) == NOTHING
    assert bench.refusal("one", live.Survey()) == NOTHING
    assert bench.take("one") == request.Done()
    assert bench.refusal("one", live.Change("s0", off=("t",))) == NOTHING


def test_who_depends_on_a_lease(bench):  # R-X12
    bench.subsystems.live |= {"s0": Live("one"), "s1": Live()}
    bench.runs("two", "flow0")
    bench.runs("ann#1", "flow1", on_loss="run")
    bench.runs("", "flow2")
    assert bench.authority.needed == {"one", "two"}


def test_in_a_stop_tasks_go_off_and_none_comes_to_life(bench):  # law 27
    spawn = live.Change("s0", spawn=("a task",))
    for message in (live.Change("s0", on=("t",)), spawn):
        assert bench.refusal("one", message, is_stopped=True) == Reason.of("host.is_stopped")
        assert bench.refusal("one", message) == NOTHING
    assert bench.refusal("one", live.Change("s0", off=("t",)), is_stopped=True) == NOTHING
    assert bench.refusal("one", live.Clear("s0", "t"), is_stopped=True) == NOTHING


def test_what_is_steered_is_judged_by_the_run(bench):
    assert bench.refusal("one", steer.Pause()) == Reason.plain(f"one: {steer.Pause()!r}")


def test_an_application_is_changed_by_nobody_and_answered_by_its_session(bench):  # R-X12
    bench.runs("one", "flow0")
    refused = Reason.of("host.runs_in", application="work", subsystem="flow0")
    assert bench.refusal("one", live.Change("flow0", off=("t",))) == refused
    assert bench.refusal("one", request.Reply("flow0", "t", "1")) == NOTHING
    held = Reason.of("host.held_stop", subsystem="flow0", holder="one")
    assert bench.refusal("two", request.Reply("flow0", "t", "1")) == held


def test_an_application_begins_where_nobody_else_is(bench):  # R-A06
    bench.subsystems.live |= {"s0": Live("one"), "s1": Live("two"), "s2": Live("one", "t"), "s3": Live()}
    bench.runs("one", "flow0")
    occupied = bench.authority.occupied
    assert occupied("one", ["s0", "s3", "s9"]) == NOTHING
    assert set(bench.subsystems.live) == {"s1", "s2"}
    assert occupied("one", ["s1"]) == Reason.of("host.held_elsewhere", subsystem="s1", holder="two")
    assert occupied("one", ["s2"]) == Reason.of("host.has_tasks", subsystem="s2", tasks=("t",))
    runs_in = Reason.of("host.runs_in_already", application="work", subsystem="flow0")
    assert occupied("one", ["flow0"]) == occupied("two", ["flow0"]) == runs_in


@pytest.mark.parametrize(("on_loss", "abandoned"), [("stop", True), ("run", False)])
def test_a_stop_is_left_by_whoever_holds_something_or_when_nobody_does(bench, on_loss, abandoned):  # law 27
    bench.subsystems.live["s0"] = Live()
    assert bench.refusal("two", live.Reset()) == NOTHING
    bench.runs("one", "flow0", on_loss=on_loss)
    assert bench.refusal("one", live.Reset()) == NOTHING
    assert bench.refusal("two", live.Reset()) == Reason.of("host.stop_of_holder", names=("one",))
    bench.subsystems.live["s0"].holder = "two"
    assert bench.refusal("two", live.Reset()) == NOTHING


def test_who_takes_holds_and_who_takes_what_he_holds_holds_it_still(bench):  # R-X12
    assert bench.take("one") == bench.take("one") == request.Done()
    assert bench.told == [(event.Held("s0", "one", NOTHING), "s0", "one")]
    held = request.Refused(Reason.of("host.held_by", subsystem="s0", holder="one"))
    assert bench.take("two") == held


def test_what_was_given_back_is_told_to_who_held_it_and_is_no_more_if_empty(bench):  # R-X12
    bench.take("one")
    bench.subsystems.live["s1"] = Live("one", "t")
    bench.told.clear()
    assert bench.release("one") == bench.release("one", "s1") == bench.release("one", "s9") == request.Done()
    assert bench.told == [(event.Held(name, "", NOTHING), name, "one") for name in ("s0", "s1")]
    assert set(bench.subsystems.live) == {"s1"}


def test_a_change_makes_a_holder_only_if_it_was_accepted(bench):  # R-X12
    bench.subsystems.live["s0"] = Live()
    refused = request.Refused(NOTHING)
    assert bench.authority.takes("one", "s0", refused) is refused
    assert bench.subsystems.live["s0"].holder == ""
    accepted = live.Accepted(1)
    assert bench.authority.takes("one", "s0", accepted) is accepted
    assert bench.subsystems.live["s0"].holder == "one"


def test_who_only_watches_gives_everything_back_first(bench):  # R-X12
    bench.take("one", "s1")
    bench.runs("one", "flow0", "flow1")
    bench.runs("two", "flow2")
    names = ("flow0", "flow1", "s1")
    assert bench.authority.only_watch("one") == request.Refused(Reason.of("host.holds_still", names=names))
    assert bench.authority.only_watch("ann#1") == request.Done()
    assert bench.authority.watching == {"ann#1"}
    assert bench.refusal("ann#1", live.Take("s0")) == Reason.of("host.watches_only")
    assert bench.refusal("ann#1", request.Stop(Reason.plain("x"))) == bench.refusal("ann#1", live.Survey()) == NOTHING


def test_only_what_one_holds_can_be_handed_over(bench):  # R-X12
    assert bench.hand("one", "two") == request.Refused(Reason.of("host.hand_free", subsystem="s0"))
    bench.take("one")
    held = request.Refused(Reason.of("host.hand_held", subsystem="s0", holder="one"))
    assert bench.hand("two", "ann#1") == held


def test_an_offer_is_withdrawn_by_who_made_it(bench):  # R-X12
    bench.take("one")
    nobody = request.Refused(Reason.of("host.offered_nobody", subsystem="s0"))
    assert bench.hand("one", "") == nobody
    bench.hand("one", "two")
    bench.keys()
    assert bench.hand("one", "") == request.Done()
    assert bench.keys() == [("s0", "one", "host.offer_withdrawn")]
    assert bench.hand("one", "") == nobody


def test_an_offer_that_is_taken_makes_another_holder(bench):  # R-X12
    bench.take("one")
    assert bench.hand("one", "two") == request.Done()
    bench.told.clear()
    assert bench.take("two") == request.Done()
    assert bench.told[-1] == (event.Held("s0", "two", Reason.of("host.handed_over", holder="one")), "s0", "two")
    assert bench.keys()[0] == ("s0", "one", "host.offer_accepted")
    assert bench.subsystems.live["s0"].holder == "two"


def test_an_offer_is_for_who_it_was_made_for(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two")
    bench.keys()
    nobody = request.Refused(Reason.of("host.offers_nobody", subsystem="s0"))
    assert bench.authority.decline("ann#1", holding.Decline("s0")) == nobody
    assert bench.take("ann#1") == request.Refused(Reason.of("host.held_by", subsystem="s0", holder="one"))
    assert bench.authority.decline("two", holding.Decline("s0")) == request.Done()
    declined = Reason.of("host.offer_declined", session="two")
    assert bench.told == [(event.Offered("s0", "one", "two", declined), "s0", "one")]
    assert bench.authority.decline("two", holding.Decline("s0")) == nobody


def test_an_offer_ends_with_its_time(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two", wall_ns=5)
    bench.keys()
    bench.authority.expire(5 + MINUTE_NS - 1)
    assert bench.keys() == []
    bench.authority.expire(5 + MINUTE_NS)
    assert bench.keys() == [("s0", "one", "host.offer_unanswered")]


def test_an_offer_of_who_holds_it_no_more_is_worth_nothing(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two")
    bench.subsystems.live["s0"].holder = "ann#1"
    bench.keys()
    assert bench.take("two") == request.Refused(Reason.of("host.held_by", subsystem="s0", holder="ann#1"))
    assert bench.keys() == [("s0", "one", "host.offer_overtaken")]


@pytest.mark.parametrize(
    ("to", "reason"),
    [
        ("ann", Reason.of("host.handed_to", names=("ann#1", "ann#2"), to="ann")),
        ("bob", Reason.of("host.handed_to", names=("two", "ann#1", "ann#2"), to="bob")),
        ("one", Reason.of("host.handed_to", names=("two", "ann#1", "ann#2"), to="one")),
    ],
)
def test_who_is_meant_has_to_be_one_and_another(bench, to, reason):  # R-X12
    bench.take("one")
    assert bench.hand("one", to) == request.Refused(reason)


def test_a_session_is_meant_by_its_name_before_others_by_their_user(bench):  # R-X12
    bench.standings.append(holding.SessionStanding("ann", "operator"))
    bench.take("one")
    assert bench.hand("one", "ann") == request.Done()
    assert bench.told[-1] == (event.Offered("s0", "one", "ann"), "s0", "ann")


def test_a_user_with_one_session_is_meant_by_his_name(bench):  # R-X12
    bench.standings[2:] = [
        holding.SessionStanding("ann#1", "operator", is_here=False),
        holding.SessionStanding("ann#2", "operator"),
    ]
    bench.take("one")
    assert bench.hand("one", "ann") == request.Done()
    assert bench.told[-1][0].to == "ann#2"


@pytest.mark.parametrize("standing", [{"role": "viewer"}, {"role": "operator", "only_watches": True}])
def test_nothing_is_handed_to_who_takes_nothing(bench, standing):  # R-X12
    bench.standings.append(holding.SessionStanding("eve", **standing))
    bench.take("one")
    assert bench.hand("one", "eve") == request.Refused(Reason.of("host.takes_nothing", name="eve"))


def test_who_is_alone_hands_to_nobody(bench):  # R-X12
    del bench.standings[1:]
    bench.take("one")
    assert bench.hand("one", "two") == request.Refused(Reason.of("host.handed_alone", to="two"))


def test_what_a_silent_holder_holds_comes_to_rest_and_is_nobodys(bench):  # R-X12
    subsystem = bench.subsystems.live["s0"] = Live("one", "t")
    other = bench.subsystems.live["s1"] = Live("two", "t")
    run, going_on = bench.runs("one", "flow0", "flow1"), bench.runs("one", "flow2", on_loss="run")
    bench.authority.lapse("one", 250_000_000, 7)
    cause = Reason.of("host.holder_silent", session="one", seconds=0.25)
    assert run.abandoned == [(cause, 7)]
    assert (run.session, going_on.session, going_on.abandoned) == ("", "one", [])
    assert (subsystem.holder, subsystem.begun) == ("", [(0, True)])
    assert (other.holder, other.begun) == ("two", [])
    assert bench.told == [(event.Held(name, "", cause), name, "one") for name in ("flow0", "flow1", "s0")]


def test_what_a_lost_session_held_comes_to_rest_and_all_its_runs_are_nobodys(bench):  # R-X12
    subsystem = bench.subsystems.live["s0"] = Live("one", "t")
    run, going_on = bench.runs("one", "flow0"), bench.runs("one", "flow2", on_loss="run")
    bench.authority.lost("one", 9)
    cause = Reason.of("host.run_deserted", session="one")
    assert run.abandoned == going_on.abandoned == [(cause, 9)]
    assert (run.session, going_on.session, subsystem.begun) == ("", "", [(0, True)])
    assert bench.told == [
        (event.Held("flow0", "", cause), "flow0", "one"),
        (event.Held("flow2", "", cause), "flow2", "one"),
        (event.Held("s0", "", Reason.of("host.holder_gone", session="one")), "s0", "one"),
    ]


def test_who_is_gone_offers_nothing_and_is_offered_nothing(bench):  # R-X12
    bench.take("one")
    bench.hand("one", "two")
    bench.keys()
    bench.authority.lost("two", 9)
    assert bench.keys() == [("s0", "one", "host.offer_deserted")]


def test_a_run_of_nobody_is_taken_with_all_its_subsystems(bench):  # R-X12
    run = bench.runs("", "flow0", "flow1")
    assert bench.take("two", "flow1") == request.Done()
    assert run.session == "two"
    cause = Reason.of("host.run_of_nobody")
    assert bench.told == [(event.Held(name, "two", cause), name, "two") for name in ("flow0", "flow1")]
    held = request.Refused(Reason.of("host.held_by", subsystem="flow0", holder="two"))
    assert bench.take("one", "flow0") == held
    assert bench.take("two", "flow0") == request.Refused(Reason.of("host.held_by", subsystem="flow0", holder="two"))


def test_a_run_is_handed_over_with_all_its_subsystems_and_what_was_offered_of_them(bench):  # R-X12
    run = bench.runs("one", "flow0", "flow1")
    bench.hand("one", "ann#1", "flow0")
    bench.hand("one", "two", "flow1")
    bench.told.clear()
    assert bench.take("two", "flow1") == request.Done()
    assert (run.session, bench.subsystems.released) == ("two", ["one"])
    assert bench.keys() == [
        ("flow1", "one", "host.offer_accepted"),
        ("flow0", "one", "host.offer_passed_on"),
        ("flow0", "two", "host.handed_over"),
        ("flow1", "two", "host.handed_over"),
    ]


def test_what_is_given_back_is_offered_to_nobody_any_more(bench):  # R-X12
    bench.subsystems.live["s0"] = Live("one", "t")
    bench.hand("one", "two")
    bench.keys()
    bench.release("one")
    assert bench.keys() == [("s0", "one", "host.offer_released"), ("s0", "one", "")]
