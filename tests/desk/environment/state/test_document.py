from dataclasses import replace
from pathlib import Path

import pytest

from onika.desk.environment.state.content import Content
from onika.desk.environment.state.document import Document
from onika.model.configuration import Configuration, Group, Locus, Placed
from onika.store.opened_text import OpenedText

SAVED = Configuration("c", (Placed("pd", 1, 2), Placed("diff")), (Locus("Q", 3, 4),))


def document(configuration):
    return Document("c1", Content(configuration), opened=OpenedText(SAVED, Path("c.conf"), ""))


def test_what_was_saved_is_not_dirty():  # R-C06
    assert not document(SAVED).is_dirty
    assert not document(SAVED).is_moved


@pytest.mark.parametrize(
    "looks",
    [
        replace(SAVED, placed=(Placed("pd", 9, 9), Placed("diff"))),
        replace(SAVED, placed=(Placed("pd", 1, 2, in_left=False), Placed("diff"))),
        replace(SAVED, loci=(Locus("Q", 9, 9),)),
        replace(SAVED, loci=(Locus("Q", 3, 4, show=False),)),
    ],
)
def test_looks_alone_are_a_lesser_change(looks):  # R-C06
    assert (document(looks).is_dirty, document(looks).is_moved) == (False, True)


@pytest.mark.parametrize(
    "placed",
    [
        (Placed("pd", 1, 2),),
        (Placed("pd", 1, 2, frequency=100.0), Placed("diff")),
        (Placed("pd", 1, 2, rtpu="rt1"), Placed("diff")),
    ],
)
def test_other_tasks_rates_or_units_are_a_change(placed):  # R-C06
    changed = document(replace(SAVED, placed=placed))
    assert (changed.is_dirty, changed.is_moved) == (True, False)


def test_a_blank_configuration_is_dirty_once_something_is_placed():  # R-C21
    assert not Document("c1", Content(Configuration("Untitled-1"))).is_dirty
    assert Document("c1", Content(Configuration("Untitled-1", (Placed("pd"),)))).is_dirty


def test_another_supermodule_or_order_is_a_change():  # R-C06, R-C17
    first, other = (replace(SAVED, groups=(Group("arm", tasks),)) for tasks in (("pd", "diff"), ("diff", "pd")))
    assert document(first).is_dirty
    assert Document("c1", Content(other), opened=OpenedText(first, Path("c.conf"), "")).is_dirty
