import copy
from typing import Any

import msgspec
from hypothesis import given, strategies as st

from onika.desk.environment.show.tree_difference import difference
from onika.wire.view import DocumentView, LocusView, PlacedView, Tree
from onika.words.reason import Reason

leaves = st.one_of(st.integers(), st.text(max_size=3), st.lists(st.integers(), max_size=2), st.booleans())
names = st.text(max_size=2)
trees = st.recursive(
    st.dictionaries(names, leaves, max_size=4),
    lambda deeper: st.dictionaries(names, st.one_of(leaves, deeper), max_size=4),
    max_leaves=20,
)


def applied(tree: Any, changes: Any) -> Any:
    tree = copy.deepcopy(tree)
    for path, value in changes:
        *way, last = path
        at = tree
        for step in way:
            at = at[step]
        if value is None:
            del at[last]
        else:
            at[last] = value
    return tree


@given(trees, trees)
def test_the_difference_turns_one_tree_into_the_other(before, after):
    assert applied(before, difference(before, after)) == after


@given(trees)
def test_equal_trees_have_no_difference(tree):
    assert difference(tree, copy.deepcopy(tree)) == []


def test_only_the_field_that_changed_is_told():
    before = Tree(documents={"c1": DocumentView("a", 0, tasks={"pd": PlacedView(1, 2)})})
    after = Tree(documents={"c1": DocumentView("a", 0, tasks={"pd": PlacedView(5, 2)})})
    assert difference(before, after) == [(("documents", "c1", "tasks", "pd", "x"), 5)]


def test_what_is_new_travels_whole_and_what_is_gone_as_nothing():
    before = DocumentView("a", 0, tasks={"pd": PlacedView(1, 2)})
    after = DocumentView("a", 0, loci={"Q": LocusView(3, 4)})
    assert difference(before, after) == [
        (("tasks", "pd"), None),
        (("loci", "Q"), msgspec.to_builtins(LocusView(3, 4))),
    ]


def test_what_is_as_by_default_travels_as_nothing():  # R-C12: a snapshot leaves it out, too
    before = Tree(
        documents={"c1": DocumentView("a", 0, redo=Reason.plain("placing"), tasks={"pd": PlacedView(1, 2, rtpu="rt1")})}
    )
    after = Tree(documents={"c1": DocumentView("a", 0, tasks={"pd": PlacedView(1, 2)})})
    assert dict(difference(before, after)) == {
        ("documents", "c1", "redo"): None,
        ("documents", "c1", "tasks", "pd", "rtpu"): None,
    }


def test_a_sentence_is_replaced_whole():  # R-X01
    before, after = Tree(icon_clipboard=Reason.plain("two icons")), Tree(icon_clipboard=Reason.plain("one icon"))
    assert difference(before, after) == [(("icon_clipboard",), {"key": "plain", "text": "one icon"})]
