import pytest

from onika.wire.foresight import Effect, Foresight, WhatIf
from onika.words.reason import Reason

STOP = Foresight("stop", "", Reason.of("foresight.stop"))
FAILS = Foresight(
    "task",
    "main/pd",
    Reason.of("foresight.task_fails", task="main/pd"),
    Reason.plain("yard:m1 holds within 0 ms"),
    (Effect(0.0, "drive", "yard:m1", "DRIVEN", "HELD", Reason.plain("it holds"), "Drive"),),
    (Reason.of("foresight.do_clear", tasks=("main/pd",)),),
    (Reason.of("foresight.error_entry"),),
)


@pytest.fixture
def foreseeing(sit):
    sitting = sit()
    sitting.runtime.foresights = (STOP, FAILS)
    return sitting


def test_without_a_word_it_is_listed_what_can_be_asked(foreseeing):  # R-X24
    assert [line.split(maxsplit=2) for line in foreseeing.does("what-if")] == [
        ["fault", "whom", "question"],
        ["stop", "-", "What if everything is stopped?"],
        ["task", "main/pd", "What if main/pd fails?"],
    ]


def test_an_answer_is_told_with_what_changes_and_what_is_to_do(foreseeing):  # R-X24
    question, answer, head, row, deed, note = foreseeing.does("what-if task main/pd")
    assert question == "What if main/pd fails?"
    assert answer == "yard:m1 holds within 0 ms"
    assert head.split() == ["within/ms", "changes", "whom", "before", "after"]
    assert row.split() == ["0", "drive", "yard:m1", "DRIVEN", "HELD"]
    assert deed == "To do then: Clear main/pd, then turn it on again."
    assert note.startswith("This counts for a fault that")


def test_only_what_if_is_asked_and_nothing_else(foreseeing):  # R-X24
    foreseeing.runtime.asked.clear()
    foreseeing.does("what-if task main/pd")
    assert foreseeing.requests_of(WhatIf) == [WhatIf("task", "main/pd")]
    assert [type(asked).__name__ for asked in foreseeing.runtime.asked if not isinstance(asked, WhatIf)] == []


def test_what_the_runtime_refuses_to_foresee_is_a_fault(foreseeing):  # R-X24
    assert foreseeing.fails("what-if flood").reason.key == "foresight.cannot_come"


def test_faults_and_those_whom_they_concern_are_completed(foreseeing):  # R-X24
    candidates = foreseeing.console.completion.candidates
    assert candidates("what-if ta") == ["task"]
    assert candidates("what-if task m") == ["main/pd"]
