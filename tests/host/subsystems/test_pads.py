"""Pads: a push is written where a task listens, for who holds the subsystem, one hand at a time."""

import pytest

from kit.runtime.live_edits import COUNTER, LiveEdits
from onika.model import pad
from onika.wire import live, request
from onika.words.reason import Reason

LISTENER = """
from onika.module import InVar, Module, OutVar

class Listener(Module):
    PAD = InVar("double[11]", "-", "a pad")
    SEEN = OutVar("double", "-", "nothing")

    def cycle(self):
        self.SEEN = self.PAD[5]
"""
SHORT = LISTENER.replace("double[11]", "double[6]").replace("PAD[5]", "PAD[0]").replace("Listener", "Short")
PLAYER = """
from onika.module import Module, OutVar

class Player(Module):
    PAD = OutVar("double[11]", "-", "a pad")

    def cycle(self):
        pass
"""
AXES = (0.5, -2.0, 0.0, 0.0, 0.0, 1.0)


@pytest.fixture
def hand():
    edits = LiveEdits()
    for name, source in (("listener", LISTENER), ("counter", COUNTER), ("player", PLAYER), ("short", SHORT)):
        edits.task(name, source)
    assert edits.change(spawn=["listener", "counter"], on=["listener", "counter"]) == ""
    return edits


def push(edits, axes=AXES, held=True, session="me", **more):
    return edits.asker.ask(live.Push(axes, held, **more), session)


def written(edits, subsystem="s0"):
    return edits.asker.ask(live.Read(subsystem, (pad.NAME,))).values[pad.NAME]


def test_a_push_is_written_with_a_new_count_each_time_and_within_its_limits(hand):  # R-K07, law 27
    assert push(hand, scale=3.0, frame="tool", button=True) == request.Done()
    assert written(hand) == [1.0, 1.0, 1.0, 1.0, 1.0, 0.5, -1.0, 0.0, 0.0, 0.0, 1.0]
    assert push(hand, held=False) == request.Done()
    assert written(hand)[:5] == [2.0, 0.0, 1.0, 0.0, 0.0]
    hand.let_pass(0.1)
    assert hand.asker.ask(live.Read("s0", ("SEEN",))).values == {"SEEN": 0.5}
    assert hand.asker.ask(live.Check("s0")) == live.Findings(())


def test_who_does_not_hold_the_subsystem_leads_nobody(hand):  # law 27
    no = Reason.of("host.pad_held", subsystem="s0", holder="me")
    assert push(hand, session="other") == request.Refused(no)
    assert hand.asker.ask(live.Release("s0")) == request.Done()
    assert push(hand) == request.Refused(Reason.of("host.pad_of_nobody", subsystem="s0"))
    assert written(hand)[0] == 0.0


def test_where_no_task_that_is_on_listens_a_push_is_refused(hand):  # R-K07
    hand.change(off=["listener"])
    assert push(hand) == request.Refused(Reason.of("host.no_pad"))
    assert push(hand, subsystem="s0") == request.Refused(Reason.of("host.no_pad_in", subsystem="s0"))
    assert push(hand, subsystem="nowhere") == request.Refused(Reason.of("host.no_pad_in", subsystem="nowhere"))


def test_a_pad_that_a_task_plays_is_nobody_elses(hand):
    assert hand.change(spawn=["player"]) == ""
    assert push(hand) == request.Refused(Reason.of("host.no_pad"))


def test_a_variable_of_that_name_that_is_no_pad_is_left_alone():
    edits = LiveEdits()
    edits.task("short", SHORT)
    edits.change(spawn=["short"], on=["short"])
    assert push(edits) == request.Refused(Reason.of("host.no_pad"))


def test_one_hand_leads_at_a_time_until_it_lets_go_or_falls_silent(hand):  # R-K07
    taken = request.Refused(Reason.of("host.pad_taken"))
    assert push(hand, source="ann") == request.Done()
    assert push(hand, source="bob") == taken
    assert push(hand, source="bob", held=False) == taken
    assert push(hand, source="ann", held=False) == request.Done()
    assert push(hand, source="bob") == request.Done()
    assert push(hand, source="ann") == taken
    hand.let_pass(1.1)
    assert push(hand, source="ann") == request.Done()


def test_where_several_listen_the_subsystem_has_to_be_named(hand):
    hand.change(subsystem="s1", spawn=["listener"], on=["listener"])
    assert push(hand) == request.Refused(Reason.of("host.one_subsystem", names=("s0", "s1")))
    assert push(hand, subsystem="s1") == request.Done()
    assert (written(hand)[0], written(hand, "s1")[0]) == (0.0, 1.0)
