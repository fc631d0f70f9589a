from dataclasses import replace

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from kit.desk.live_runtime import LiveRuntime
from onika.desk.environment.reconcile.runtime_loss import with_loads
from onika.model.task import Task
from onika.wire import act

TASKS = (
    Task("light", "light", outvar=("A",), frequency=100.0),
    Task("heavy", "heavy", outvar=("B",), frequency=100.0),
    Task("rival", "rival", outvar=("A",), frequency=100.0),
)
DIGESTS = {"light": "l", "heavy": "h", "rival": "r"}
CYCLES_US = {"l": 500.0, "h": 6000.0, "r": 9000.0}


@pytest.fixture
def duet(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, TASKS, LiveRuntime())
    duet.doc = duet.connected("light")
    duet.environment.become(
        lambda model: with_loads(
            replace(model, libraries=replace(model.libraries, digests=DIGESTS)), {"rt0": 0.5, "rt1": 0.6}, CYCLES_US
        )
    )
    return duet


def busy(duet, load):
    loads = dict.fromkeys(duet.environment.model.runtime.units, load)
    duet.environment.become(lambda model: with_loads(model, loads, CYCLES_US))


def greyed(duet):
    return duet.environment.tree.documents[duet.doc].greyed


def test_the_share_that_a_task_would_take_is_shown_before_it_is_placed(duet):  # R-X13
    assert duet.environment.tree.loads == {"light": 0.05, "heavy": 0.6, "rival": 0.9}


def test_a_task_whose_code_was_never_measured_has_no_number_and_is_not_greyed(duet):  # R-X13
    units = dict.fromkeys(duet.environment.model.runtime.units, 0.99)
    duet.environment.become(lambda model: with_loads(model, units, {"l": 500.0}))
    assert duet.environment.tree.loads == {"light": 0.05}
    assert "heavy" not in greyed(duet)


def test_a_task_that_would_overload_every_unit_is_greyed_with_the_number(duet):  # R-X13
    busy(duet, 0.3)
    assert "heavy" not in greyed(duet)
    busy(duet, 0.5)
    (why,) = greyed(duet)["heavy"]
    assert "0.60" in str(why.text) and "1.10" in str(why.text)


def test_a_lower_rate_makes_room(duet):  # R-X13
    busy(duet, 0.5)
    duet.do(act.LibraryRate("heavy", 50.0))
    assert duet.environment.tree.loads["heavy"] == 0.3
    assert "heavy" not in greyed(duet)


def test_a_task_that_the_rules_keep_out_says_that_first(duet):  # R-X13, R-X01
    busy(duet, 0.5)
    rules, time = greyed(duet)["rival"]
    assert "0.90" in str(time.text) and "0.90" not in str(rules.text)


def test_a_document_that_is_not_connected_greys_nothing_for_want_of_time(duet):  # R-X13
    busy(duet, 0.99)
    other = duet.new()
    assert "heavy" not in duet.environment.tree.documents[other].greyed


def test_shares_that_look_the_same_are_the_same_object(duet):  # R-X02
    before = duet.environment.tree.loads
    duet.environment.become(lambda model: with_loads(model, {}, {**CYCLES_US, "l": 501.0}))
    assert duet.environment.tree.loads is before
