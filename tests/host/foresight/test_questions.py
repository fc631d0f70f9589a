import pytest

from kit.faults.fault_planting import FaultyRuntime
from onika.wire import request
from onika.wire.foresight import WhatIf


@pytest.fixture
def runtime():
    return FaultyRuntime().start()


def test_without_a_fault_it_is_said_what_can_be_asked(runtime):  # R-X24
    asked = runtime.questions()
    assert ("task", "flow0/push") in asked
    assert ("button", "yard:m1") in asked
    assert ("disk", "") not in asked, "nothing is recorded"
    assert all(foresight.answer is None for foresight in runtime.foresee())


@pytest.mark.parametrize(
    ("fault", "subject", "key"),
    [
        ("flood", "", "foresight.no_such_fault"),
        ("task", "flow0/nobody", "foresight.not_concerned"),
        ("task", "", "foresight.say_whom"),
        ("disk", "", "foresight.cannot_come"),
    ],
)
def test_what_cannot_be_asked_is_refused_with_what_can(runtime, fault, subject, key):  # R-X24
    assert runtime.ask(WhatIf(fault, subject)).reason.key == key


def test_without_a_plan_nothing_is_foreseen_of_one(runtime):  # R-X24
    answer = runtime.ask(WhatIf("stop", is_planned=True), "somebody")
    assert isinstance(answer, request.Refused)
