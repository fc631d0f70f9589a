"""Black boxes of subsystems that are held by hand, in virtual time (requirement X05)."""

from pathlib import Path

import pytest

from kit.runtime.live_edits import COUNTER, LiveEdits
from onika.desk.run.run_review import Review
from onika.host.recording.black_box_holder import InProcessHolder
from onika.host.recording.hand_held import MOST_INCIDENTS, WITHIN_NS, incident_cause
from onika.record.black_box_folder import black_boxes
from onika.wire import event, live, request
from onika.words.reason import NOTHING, Reason

MASS = """
from onika.module import InVar, Module, ModuleError, OutVar

class Mass(Module):
    hardware = True

    FORCE = InVar("double", "N", "what pushes it")
    X = OutVar("double", "m", "where it is")

    def cycle(self):
        self.X = self.device.read()[0]
        if self.device.is_tripped:
            raise ModuleError("the drive has tripped")
        self.device.write((self.FORCE,))
"""
PUSH = """
from onika.module import Module, ModuleError, OutVar

class Push(Module):
    FORCE = OutVar("double", "N", "what pushes it")

    def on(self, inputs):
        self._is_sick = False

    def cycle(self):
        if self._is_sick:
            raise ModuleError("sick")
        self.FORCE = self.FORCE + 1.0
"""
ROW = """
from onika.module import Module, OutVar

class Row(Module):
    ROW = OutVar("double[3]", "m", "three of them")

    def cycle(self):
        self.ROW = [1.0, 2.0, 3.0]
"""


class ByHand:
    """A mass that is pushed, both tasks ON by hand, on a runtime with a black box."""

    def __init__(self, folder, rtpus=("rt0",), **where):
        self.folder = folder
        self.edits = LiveEdits(rtpus)
        self.edits.asker.program.recordings.keep_last_seconds(folder, InProcessHolder(), InProcessHolder)
        self.edits.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"})
        self.edits.task("push", PUSH, frequency=500.0, **where)
        assert self.edits.change(spawn=("mass", "push"), on=("mass", "push")) == ""
        self.edits.let_pass(0.2)

    @property
    def kept(self):
        return self.edits.asker.of(event.LastSecondsKept)

    @property
    def files(self):
        return sorted(str(path) for path in black_boxes(self.folder))

    def sicken(self):
        self.edits.driver.living()["s0", "push"].module._is_sick = True
        self.edits.let_pass(0.1)

    def heal(self):
        for task in ("push", "mass"):
            assert self.edits.clear(task) == ""
        assert self.edits.change(on=("mass", "push")) == ""
        self.edits.let_pass(0.1)


@pytest.fixture
def by_hand(tmp_path):
    return ByHand(tmp_path / "boxes")


def test_a_task_that_fails_leaves_the_last_seconds_and_they_are_named(by_hand):  # R-X05
    by_hand.sicken()
    (kept,) = by_hand.kept
    assert by_hand.files == [kept.path]
    assert (kept.subsystem, kept.run) == ("s0", "")
    with Review(Path(kept.path)) as review:
        assert review.is_whole
        assert (review.run.is_by_hand, review.run.prepare.plan.application) == (True, "s0")
        (flow,) = review.run.prepare.plan.flows
        assert {task.name for task in flow.tasks} == {"mass", "push"}
        assert {code.digest for code in review.run.prepare.plan.code} == {task.digest for task in flow.tasks}
        assert "sick" in review.ending["cause"]
        assert review.black_box.goes_on
        last = review.at(review.span_s[1])
        assert last.tasks["s0/push"] == last.tasks["s0/mass"] == "ERROR"
        assert last.variables["s0/FORCE"] == by_hand.edits.values("FORCE")["FORCE"] > 50.0
        assert review.series["s0/FORCE"].unit == "N"


def test_what_goes_well_leaves_nothing(by_hand):  # R-X05
    assert by_hand.edits.change(off=("mass", "push")) == ""
    by_hand.edits.let_pass(60.0)
    assert by_hand.edits.outcome(by_hand.edits.asker.ask(live.Close("s0"))) == ""
    by_hand.edits.asker.program.close()
    assert (by_hand.kept, by_hand.files) == ([], [])


def test_what_was_asked_by_hand_is_in_it(by_hand):  # R-X05
    by_hand.edits.asker.ask(live.Touch("yard", "panic", 1.0))
    by_hand.edits.let_pass(0.1)
    (kept,) = by_hand.kept
    with Review(Path(kept.path)) as review:
        assert live.Touch("yard", "panic", 1.0) in [message for _, message in review.commands]
        assert review.at(review.span_s[1]).drives["yard:m0"] == "PRESSED"


def test_a_stop_of_everything_leaves_the_last_seconds(by_hand):  # R-X05, law 27
    by_hand.edits.asker.ask(request.Stop(Reason.plain("red button")))
    by_hand.edits.let_pass(0.1)
    (kept,) = by_hand.kept
    with Review(Path(kept.path)) as review:
        assert review.ending["cause"] == "red button"


def test_a_stop_while_nothing_is_on_leaves_nothing(by_hand):  # R-X05
    assert by_hand.edits.change(off=("mass", "push")) == ""
    by_hand.edits.let_pass(2.0)
    by_hand.edits.asker.ask(request.Stop(Reason.plain("red button")))
    by_hand.edits.let_pass(0.1)
    assert by_hand.kept == []


def test_a_lost_unit_leaves_the_last_seconds_of_what_it_carried_out(tmp_path):  # R-X05, R-E10
    by_hand = ByHand(tmp_path / "boxes", ("rt0", "rt1"), rtpu="rt1")
    by_hand.edits.driver.lose("rt1")
    by_hand.edits.work()
    (kept,) = by_hand.kept
    with Review(Path(kept.path)) as review:
        assert "rt1" in review.ending["cause"]


def test_a_holder_that_falls_silent_leaves_the_last_seconds_and_one_that_leaves_does_not(by_hand):  # R-X05, R-X12
    asker = by_hand.edits.asker
    asker.lease(250_000_000)
    asker.server.silent["me"] = 260_000_000
    asker.program.serve()
    by_hand.edits.work()
    assert len(by_hand.kept) == len(by_hand.files) == 1
    asker.server.silent["me"] = 0
    assert by_hand.edits.asker.ask(live.Take("s0")) == request.Done()
    assert by_hand.edits.change(on=("mass", "push")) == ""
    asker.server.gone.append("me")
    asker.program.serve()
    by_hand.edits.work()
    assert set(by_hand.edits.states.values()) == {"OFF"}
    assert len(by_hand.kept) == len(by_hand.files) == 1


def test_the_second_time_has_a_file_of_its_own(by_hand):  # R-X05
    by_hand.sicken()
    by_hand.heal()
    by_hand.sicken()
    assert len(set(by_hand.files)) == 2
    assert by_hand.files == sorted(kept.path for kept in by_hand.kept)


@pytest.mark.slow
def test_who_tries_again_and_again_fills_no_folder(by_hand):  # R-X05
    for _ in range(MOST_INCIDENTS + 2):
        by_hand.sicken()
        by_hand.heal()
    assert len(by_hand.kept) == len(by_hand.files) == MOST_INCIDENTS
    by_hand.edits.let_pass(WITHIN_NS * 1e-9)
    by_hand.sicken()
    assert len(by_hand.kept) == MOST_INCIDENTS + 1


def test_a_runtime_that_ends_writes_what_is_still_to_be_written(by_hand):  # R-X05
    by_hand.edits.asker.program.subsystems.lost("rt0", Reason.plain("it was killed"), by_hand.edits.driver.now)
    by_hand.edits.asker.program.close()
    assert len(by_hand.files) == 1


def test_a_subsystem_that_is_closed_and_made_anew_has_last_seconds_of_its_own(by_hand):  # R-X05
    by_hand.edits.outcome(by_hand.edits.asker.ask(live.Close("s0")))
    by_hand.edits.work()
    assert by_hand.edits.change(spawn=("mass", "push"), on=("mass", "push")) == ""
    by_hand.edits.let_pass(0.1)
    by_hand.sicken()
    (kept,) = by_hand.kept
    with Review(Path(kept.path)) as review:
        assert 0.15 < review.span_s[1] < 0.3


def test_what_an_edit_has_exchanged_is_in_it_as_it_is_now(by_hand):  # R-X05, R-C12
    by_hand.edits.task("counter", COUNTER, frequency=50.0)
    by_hand.edits.task("row", ROW, frequency=50.0)
    assert by_hand.edits.change(spawn=("counter",), on=("counter",)) == ""
    by_hand.edits.let_pass(0.1)
    assert by_hand.edits.change(kill=("counter",)) == ""
    assert by_hand.edits.change(spawn=("row",), on=("row",)) == ""
    by_hand.edits.let_pass(0.1)
    by_hand.sicken()
    (kept,) = by_hand.kept
    with Review(Path(kept.path)) as review:
        assert {task.name for task in review.run.prepare.plan.flows[0].tasks} == {"mass", "push", "row"}
        last = review.at(review.span_s[1]).variables
        assert list(last["s0/ROW"]) == [1.0, 2.0, 3.0]
        assert last["s0/COUNT"] == 5.0


def test_a_black_box_changes_nothing_by_hand(by_hand, tmp_path):  # R-X05, law 14
    plain = LiveEdits()
    plain.task("mass", MASS, frequency=500.0, local={"DEVICE": "yard:m0"})
    plain.task("push", PUSH, frequency=500.0)
    assert plain.change(spawn=("mass", "push"), on=("mass", "push")) == ""
    plain.let_pass(0.2)
    assert plain.values("FORCE", "X") == by_hand.edits.values("FORCE", "X")


def test_two_subsystems_have_each_their_own(by_hand):  # R-X05
    by_hand.edits.task("counter", COUNTER, frequency=50.0)
    assert by_hand.edits.change(spawn=("counter",), on=("counter",), subsystem="s1") == ""
    by_hand.sicken()
    assert [kept.subsystem for kept in by_hand.kept] == ["s0"]
    by_hand.edits.asker.ask(request.Stop(Reason.plain("red button")))
    by_hand.edits.let_pass(0.1)
    assert [kept.subsystem for kept in by_hand.kept] == ["s0", "s0", "s1"]


CAUSE = Reason.plain("why")


@pytest.mark.parametrize(
    ("message", "is_one"),
    [
        (event.Failed("s0", "push", CAUSE, "", 0, "", 0.0), True),
        (event.Failed("s0", "nobody", CAUSE, "", 0, "", 0.0), False),
        (event.Failed("s0", "nobody", CAUSE, "", 0, "", 0.0, "on"), True),
        (event.Stopped(True, CAUSE), True),
        (event.Stopped(False, CAUSE), False),
        (event.Held("s0", "", Reason.of("host.holder_silent", session="me", seconds=0.3)), True),
        (event.Held("s0", "", Reason.of("host.holder_gone", session="me")), False),
        (event.Held("s0", "anna", CAUSE), False),
        (event.Held("s0", ""), False),
        (event.Lost("rt0", CAUSE, 0.0), True),
        (event.Lost("rt1", CAUSE, 0.0), False),
        (event.Lost("device server", CAUSE, 0.0), True),
        (event.Lost("audit trail", CAUSE, 0.0), False),
        (event.Drive("yard:m0", "TRIPPED", 0, 0, 0, CAUSE), True),
        (event.Drive("yard:m0", "PRESSED", 0, 0, 0, CAUSE), True),
        (event.Drive("yard:m0", "HELD", 0, 0, 0, CAUSE), False),
        (event.Drive("yard:m1", "TRIPPED", 0, 0, 0, CAUSE), False),
        (event.Warned("s0", "push", CAUSE, 0.0), False),
    ],
)
def test_what_goes_wrong_in_a_subsystem_at_work(by_hand, message, is_one):  # R-X05
    cause = incident_cause(message, by_hand.edits.asker.program.subsystems.live["s0"])
    assert (cause != NOTHING) == is_one
