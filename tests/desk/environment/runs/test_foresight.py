from dataclasses import replace

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.outcome.outcome import Done
from onika.wire import act, foresight, request
from onika.wire.foresight import Effect, Foresight
from onika.words.fault import NOT_RUN
from onika.words.reason import Reason

NOT_RUN_OF = (Reason.plain("it is too far"), NOT_RUN)
FAILS = Foresight(
    "task",
    "main/pd",
    Reason.of("foresight.task_fails", task="main/pd"),
    Reason.plain("it holds"),
    (
        Effect(0.0, "drive", "yard:m1", "DRIVEN", "HELD", Reason.plain("it holds"), "Drive"),
        Effect(4.0, "task", "main/pd", "ON", "ERROR", Reason.plain("it fails")),
    ),
)


@pytest.fixture
def duet(tmp_path):
    duet = FakeRuntimeEnv(tmp_path)
    duet.runtime.foresights = (FAILS,)
    return duet


@pytest.fixture
def play(tmp_path):
    play = RunFixture(tmp_path)
    play.runtime.foresights = (FAILS,)
    return play


def test_a_fault_is_put_to_the_runtime(duet):  # R-X24
    (seen,) = duet.do(act.WhatIf("task", "main/pd")).foresights
    assert (seen.fault, seen.subject, str(seen.answer)) == ("task", "main/pd", "it holds")
    assert [(effect.after, effect.within_ms, effect.is_told) for effect in seen.effects] == [
        ("HELD", 0.0, True),
        ("ERROR", 4.0, False),
    ]


def test_what_cannot_come_is_refused_as_the_runtime_says_it(duet):  # R-X24
    assert duet.answer(act.WhatIf("flood")).no.reason.key == "foresight.cannot_come"


def test_of_an_application_at_rest_its_first_step_is_asked_and_nothing_begins(play):  # R-X24
    doc = play.open([job("aC")])
    assert play.do(act.WhatIf("task", "main/pd", doc)).foresights[0].fault == "task"
    assert len(play.carried(request.Prepare)) == 1 and play.carried(request.Begin) == []
    assert play.carried(foresight.WhatIf)[-1].is_planned


def test_what_could_not_run_is_not_foreseen(play):  # R-X24
    doc = play.open([job("aC")])
    play.runtime.faults = (request.FaultText(str(play.files.path / "appl" / "play.appl"), 1, *NOT_RUN_OF),)
    assert play.answer(act.WhatIf(doc=doc)).no.reason.key == "run.not_foreseen"
    assert play.answer(act.WhatIf(doc="nobody")).no.reason.key == "run.application_closed"


def test_an_application_is_foreseen_while_another_one_runs_and_as_if_it_ran_alone(play):  # R-X24, R-C18
    first, other = play.open([job("aC")]), play.open([job("cC")], name="other")
    play.run(first)
    (seen,) = play.do(act.WhatIf("task", "main/pd", other)).foresights
    assert [note.key for note in seen.notes] == ["run.foreseen_alone"] and "play" in str(seen.notes[0])
    assert [flow.subsystem for flow in play.carried(request.Prepare)[-1].plan.flows] == ["flow0-1"]
    assert len(play.carried(request.Begin)) == 1 and play.view.state == "running"


def test_no_plan_is_prepared_beside_one_that_is_about_to_begin(play):  # R-X24
    first, other = play.open([job("aC")]), play.open([job("cC")], name="other")
    play.run(first)
    play.environment.become(lambda model: Done(replace(model, run=model.run.shown(state="beginning"))))
    assert play.answer(act.WhatIf(doc=other)).no.reason.key == "run.foreseen_after_beginning"
    assert len(play.carried(request.Prepare)) == 1
