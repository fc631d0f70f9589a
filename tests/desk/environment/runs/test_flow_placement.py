from dataclasses import replace

import pytest

from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.runs import flow_placement
from onika.wire import act, view


@pytest.fixture
def play(tmp_path):
    return RunFixture(tmp_path)


def test_a_unit_that_is_not_there_is_noted(play):  # reading 12
    play.files.configuration("aC", "a 100 rt7")
    assert tuple(map(str, play.run(play.open([job("aC")])).notes)) == ("there is no unit rt7: its tasks run on rt0",)


def test_a_unit_that_is_lost_is_told_and_it_or_a_new_runtime_is_offered(play):  # R-E10
    doc = play.open([job("aC")])
    play.run(doc)
    run = play.environment.model.run
    units = {"rt0": view.UnitView(is_lost=True), "rt1": view.UnitView(is_lost=True)}
    model = replace(play.environment.model, runtime=view.RuntimeView("linked", units=units))
    remedies = flow_placement.refused(model, run.plan).remedies
    assert [remedy.act for remedy in remedies] == [act.AddUnit("rt0"), act.StartAnew()]
    units["rt1"] = view.UnitView()
    assert flow_placement.refused(model, run.plan) is None


def test_names_that_somebody_has_are_passed_over(play):
    play.run(play.open([job("aC")], [job("bC")], parallel=True))
    plan = play.environment.model.run.plan
    model = play.environment.model
    assert flow_placement.free(model, plan, ()) == {"flow0": "flow0", "flow1": "flow1"}
    assert flow_placement.free(model, plan, ("flow0", "flow0-1", "flow1.1")) == {"flow0": "flow0-2", "flow1": "flow1-3"}
