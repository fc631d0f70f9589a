from kit.plans.plan_builder import action
from kit.runtime.runner_rig import RunnerRig
from onika.engine.engine import Engine


def test_the_engine_of_a_runner_is_that_of_its_plan():  # R-X24
    rig = RunnerRig([action("arm", "go")])
    assert isinstance(rig.runner.engine, Engine)
    assert [position.subsystem for position in rig.runner.engine.positions()] == ["flow0"]
