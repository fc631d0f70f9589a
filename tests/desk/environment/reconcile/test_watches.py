import math

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.run_fixture import RunFixture
from kit.labs.laboratory import job
from onika.desk.environment.reconcile.watches import Watch, homes_of, keys_of
from onika.model.task import Task
from onika.wire import holding, live


@pytest.fixture
def duet(tmp_path):
    return FakeRuntimeEnv(tmp_path, (Task("a", "a", outvar=("A",), frequency=10.0),))


def test_each_variable_is_asked_for_under_its_subsystem(duet):  # R-C14
    doc, other = duet.connected("a"), duet.new()
    watching = Watch(
        frozenset((f"{doc}/Q^_REF", f"{doc}/A", f"{other}/A", "c9/A", "A")), frozenset(("boxes",)), hz=30.0
    )
    attend = watching.attend(duet.environment.model)
    assert attend == live.Attend(("*",), ("Untitled-1/A", "Untitled-1/Q^_REF"), ("boxes",), 30.0)
    assert homes_of(duet.environment.model) == {doc: "Untitled-1"}


@pytest.mark.parametrize(("wished", "hz"), [(1000.0, 60.0), (0.0, 0.1), (-3.0, 0.1), (math.nan, 0.1)])
def test_nobody_is_shown_more_than_a_screen_can_show(duet, wished, hz):  # R-C14
    assert Watch(hz=wished).attend(duet.environment.model).hz == hz


def test_variables_of_a_run_are_found_in_the_first_flow_that_has_them(tmp_path):  # R-E11, R-C14
    play = RunFixture(tmp_path)
    doc = play.open([job("aC")], [job("aC"), job("bC")], parallel=True)
    wished = frozenset((f"{doc}/A", f"{doc}/flow1/A", f"{doc}/B", f"{doc}/NONE", doc))
    assert Watch(wished).attend(play.environment.model) == live.Attend(("*",), hz=0.1)
    play.run(doc)
    attend = Watch(wished).attend(play.environment.model)
    assert set(attend.readings) == {"flow0/A", "flow1/A", "flow1/B"}
    model = play.environment.model
    assert keys_of(model, "flow0/A") == (f"{doc}/flow0/A", f"{doc}/A")
    assert keys_of(model, "flow1/A") == (f"{doc}/flow1/A",)


def test_while_something_runs_here_the_runs_of_others_are_not_heard(tmp_path):  # R-E11
    play = RunFixture(tmp_path)
    play.connected("c")
    play.run(play.open([job("aC")]))
    # its own flows are heard of by their names too: it may be handed over and still belongs to this page (X12)
    assert Watch().attend(play.environment.model).subsystems == ("Untitled-1", "flow0", holding.COMPANY)
    play.end()
    assert Watch().attend(play.environment.model).subsystems == ("*",)
