import os

import pytest

from onika.cli.plain_display import PlainDisplay
from onika.desk.plan.preparation import prepare_run
from onika.desk.run.outcome import Outcome
from onika.store.site import open_site
from onika.wire import event
from onika.wire.steer import Position
from onika.words.fault import Fault, Place
from onika.words.reason import NOTHING, Reason

PREPARED = prepare_run("two_arms", open_site([], {}, None))
ITEM = event.Item("level", "double", 2, "m", "how high", None, None, None)


@pytest.fixture
def keys(monkeypatch):
    """What a user types, and then nothing any more."""
    read, write = os.pipe()
    with os.fdopen(read) as stdin:
        monkeypatch.setattr("sys.stdin", stdin)

        def give(line):
            os.write(write, line)
            os.close(write)

        yield give


def test_a_run_is_told_line_by_line(capsys):  # R-E11
    with PlainDisplay() as plain:
        plain.begins(PREPARED, 4711)
        plain.happens(event.Began(0, 0, 2, "jmoveC aside", 0.0))
        plain.happens(event.TaskState("flow0", "pd", "ON", 0.0))
    plain.ended(Outcome("two_arms"), NOTHING)
    assert capsys.readouterr().out.splitlines() == [
        "two_arms: 4 actions",
        "    0.00 s  flow0  1/2  jmoveC aside",
        "two_arms: refused, nothing moved (0 faults)",
    ]


@pytest.mark.parametrize(
    ("reason", "line"),
    [
        ("", "gauge asks for level (2 values), how high, in m:"),
        ("too low", "gauge asks for level (2 values), how high, in m (too low):"),
    ],
)
def test_a_question_is_asked_and_one_line_read(capsys, keys, reason, line):  # R-A10
    keys(b"0.5 0.75\n")
    assert PlainDisplay().answer(event.Asked("flow0", "gauge", reason, (ITEM,), 0.0)) == "0.5 0.75"
    assert capsys.readouterr().out == line + "\n"


def test_at_the_end_of_the_input_nobody_answers(keys):  # R-A10
    keys(b"")
    assert PlainDisplay().answer(event.Asked("flow0", "gauge", NOTHING, (ITEM,), 0.0)) is None


def test_a_line_of_a_script_is_told_with_what_came_of_it(capsys):  # R-E07, R-X03
    plain = PlainDisplay()
    plain.begins(PREPARED, None)
    plain.steered("pause", (), ())
    plain.steered("pass", (Fault(Place("s", 2), Reason.plain("expected one, found two"), Reason.plain("no")),), ())
    plain.steered("who", (), (Position("flow0", "running", 0),))
    plain.placed(())
    assert capsys.readouterr().out.splitlines()[1:] == [
        "> pause",
        "> pass",
        "s:2: expected one, found two; instead: no",
        "> who",
        "flow   state    action",
        "flow0  running  1/2 jmoveC aside",
    ]
    assert (plain.can_steer, plain.wishes(), plain.looks()) == (False, (), False)
