from dataclasses import replace

from hypothesis import given, strategies as st

from onika.desk.environment.state.task_edit import aliased, carried, rebased
from onika.model.task import LocalLine, Task

PINS = ("A", "B", "C")
TASK = Task("t", "t", invar=PINS, frequency=1.0)
aliases = st.dictionaries(st.sampled_from(PINS), st.sampled_from(["X", "Y", "A"])).map(
    lambda drawn: tuple((pin, drawn[pin]) for pin in PINS if pin in drawn and drawn[pin] != pin)
)
tasks = aliases.map(lambda drawn: replace(TASK, aliases=drawn))


@given(tasks, st.sampled_from(PINS), st.sampled_from(["", "X", "A", "B"]))
def test_an_alias_changes_one_pin_and_changed_back_all_is_as_it_was(filed, pin, svar):  # R-C04, R-C23
    changed = aliased(filed, pin, svar, filed)
    assert changed.svars((pin,)) == (svar or pin,)
    others = tuple(other for other in PINS if other != pin)
    assert changed.svars(others) == filed.svars(others)
    assert aliased(changed, pin, filed.svars((pin,))[0], filed) == filed


@given(tasks, tasks, tasks)
def test_what_was_changed_here_stays_and_what_was_not_is_as_the_file_says_now(former, changed, filed):  # R-C04
    aliases = dict(rebased(changed, former, filed).aliases)
    for pin in PINS:
        mine = dict(changed.aliases).get(pin) != dict(former.aliases).get(pin)
        assert aliases.get(pin) == dict((changed if mine else filed).aliases).get(pin)


@given(tasks, tasks)
def test_a_file_that_says_what_was_changed_here_leaves_nothing_changed(former, changed):  # R-C04
    assert rebased(changed, former, changed) == changed
    assert rebased(former, former, changed) == changed


def test_an_alias_of_a_pin_that_is_gone_is_gone():
    changed = replace(TASK, aliases=(("A", "X"), ("B", "Y")), local=(LocalLine("K", ("1",)),))
    filed = replace(TASK, invar=("B",), description="new")
    assert carried(changed, filed) == replace(filed, aliases=(("B", "Y"),), local=changed.local)
    assert rebased(changed, TASK, filed) == replace(filed, aliases=(("B", "Y"),), local=changed.local)
