import json
from dataclasses import replace

import pytest

from onika.desk.environment.state.clipboard import Clipboard, copied, read, write
from onika.model.configuration import Configuration, Group, Locus, Placed

TAKEN = Clipboard(
    (Placed("pd", 10, -20, False, 50.0, "rt1"), Placed("robot", 40, 5)), (Locus("Q^_REF", 7, 8, show=False),)
)


def test_what_was_copied_is_read_from_its_text_again():  # R-C10
    assert read(write(TAKEN)) == TAKEN


def test_only_the_chosen_tasks_and_the_loci_of_their_variables_are_copied():  # R-C22
    whole = Configuration("c", (*TAKEN.placed, Placed("x")), (*TAKEN.loci, Locus("OTHER")))
    assert copied(whole, ["robot", "pd"], ["Q^_REF"]) == TAKEN


def test_elsewhere_everything_keeps_its_place_to_the_upper_left_corner():  # R-C10
    moved = TAKEN.at(100, 200)
    assert [(placed.x, placed.y) for placed in moved.placed] == [(100, 200), (130, 225)]
    assert [(locus.x, locus.y) for locus in moved.loci] == [(97, 228)]


TEXT = json.loads(write(TAKEN))
TASK = TEXT["tasks"][0]


@pytest.mark.parametrize(
    ("text", "excerpt"),
    [
        (
            "dear colleague, here is what you asked for, and much more of it",
            "'dear colleague, here is what you asked f",
        ),
        ("", "''"),
        ("[]", "`object`"),
        (json.dumps({**TEXT, "onika": 2}), "version 2"),
        (json.dumps({**TEXT, "tasks": []}), "length >= 1"),
        (json.dumps({**TEXT, "tasks": [TASK, TASK]}), "pd again"),
        (json.dumps({**TEXT, "tasks": [{**TASK, "task": "../pd"}]}), "'../pd'"),
        (json.dumps({**TEXT, "tasks": [{**TASK, "rtpu": "a b"}]}), "'a b'"),
        (json.dumps({**TEXT, "tasks": [{**TASK, "hz": -1.0}]}), "at least 0 Hz"),
        (json.dumps({**TEXT, "tasks": [{**TASK, "x": 10**10}]}), "<= 1000000000"),
        (json.dumps({**TEXT, "loci": [{"svar": "q", "x": 0, "y": 0}]}), "'q'"),
        ("\ud800", "ud800"),
    ],
)
def test_another_text_is_named_by_what_it_is(text, excerpt):  # R-B07
    sentence = str(read(text))
    assert sentence.startswith("expected")
    assert excerpt in sentence


GROUPED = replace(TAKEN, groups=(Group("arm", ("robot", "pd")),))


def test_a_supermodule_is_copied_whole_or_not_at_all():  # R-C10, R-C17
    whole = Configuration("c", (*TAKEN.placed, Placed("x")), TAKEN.loci, GROUPED.groups)
    assert copied(whole, ["robot", "pd"], ["Q^_REF"]) == GROUPED
    assert copied(whole, ["robot", "x"], []).groups == ()
    assert read(write(GROUPED)) == GROUPED
    assert GROUPED.at(0, 0).groups == GROUPED.groups
    assert "groups" not in write(TAKEN)


@pytest.mark.parametrize(
    ("groups", "excerpt"),
    [
        ([{"name": "../x", "tasks": ["pd"]}], "'../x'"),
        ([{"name": "x", "tasks": []}], "length >= 1"),
        ([{"name": "x", "tasks": ["gone"]}], "'gone'"),
        ([{"name": "x", "tasks": ["pd"]}, {"name": "y", "tasks": ["pd"]}], "'pd'"),
        ([{"name": "x", "tasks": ["pd"]}, {"name": "x", "tasks": ["robot"]}], "'x'"),
    ],
)
def test_what_is_wrong_with_a_copied_supermodule_is_named(groups, excerpt):  # R-B07, R-C17
    refusal = read(json.dumps({**TEXT, "groups": groups}))
    assert str(refusal).startswith("expected") and excerpt in str(refusal)
