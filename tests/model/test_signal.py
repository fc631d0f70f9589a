"""Signals."""

import pytest
from hypothesis import given, strategies as st

from onika.model.signal import END, SignalKind, finish, illegal, legal, off, shutdown, user_signal


def test_the_kinds_are_those_of_table_9():  # R-A07
    kinds = "OFF FINISH ERROR WARNING SHUTDOWN ILLEGAL LEGAL USER"
    assert " ".join(kind.value for kind in SignalKind) == kinds


def test_each_maker_makes_its_kind():  # R-A07
    made = [off(), finish(), shutdown("a"), illegal("b"), legal(), user_signal(END + 1)]
    assert [item.kind.value for item in made] == ["OFF", "FINISH", "SHUTDOWN", "ILLEGAL", "LEGAL", "USER"]
    assert [str(item.text) for item in made] == ["", "", "a", "b", "", ""]


@given(st.integers(0, 9), st.booleans())
def test_a_finish_carries_the_flow_and_whether_loops_go_on(flow, loop):  # R-A07, R-A08
    assert (finish(flow, loop).flow, finish(flow, loop).loop) == (flow, loop)


def test_without_a_flow_it_is_flow_0_and_no_loop():  # reading 19
    assert (finish().flow, finish().loop) == (0, False)


def test_there_is_no_flow_below_0():
    with pytest.raises(ValueError, match="found -1"):
        finish(flow=-1)


@given(st.integers(0, 50))
def test_a_user_signal_beyond_whilecontinue_is_go_to_flow(flow):  # reading 19
    signal = user_signal(END + 2 + flow)
    assert (signal.flow, signal.loop) == (flow, False)


def test_the_first_user_signal_is_whilecontinue():  # reading 19
    assert (user_signal(END + 1).flow, user_signal(END + 1).loop) == (0, True)


def test_numbers_up_to_end_belong_to_the_runtime():
    with pytest.raises(ValueError, match=f"above {END}"):
        user_signal(END)
