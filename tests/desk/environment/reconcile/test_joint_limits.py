from dataclasses import replace

import pytest

from kit.desk.fake_runtime_env import FakeRuntimeEnv
from onika.desk.environment.canvas.libraries import reread
from onika.desk.environment.outcome.outcome import Done
from onika.desk.environment.state.target_items import items_of
from onika.model.task import Task
from onika.store.site import open_site
from onika.wire import act, live, request
from onika.words.reason import Reason

ARM = Task("arm", "arm", outconst=("QMIN", "QMAX", "OTHER"), frequency=100.0)
MOVE = Task("move", "move", inconst=("QMIN", "QMAX"), frequency=100.0, object_type="Joint job")
CODE = """
class Move:
    endpoint = Input("double[NDOF]", "rad", "", low="QMIN", high="QMAX")
    duration = Input("double", "s", "", low=0.1, high=600.0)
"""


@pytest.fixture
def duet(tmp_path):
    duet = FakeRuntimeEnv(tmp_path, (ARM, MOVE))
    (tmp_path / "module" / "move.py").write_text(CODE)
    syntax, _ = open_site([], {}, None).syntax()
    duet.environment.become(lambda model: Done(replace(model, syntax=syntax)))
    duet.environment.become(lambda model: reread(model, {tmp_path / "module" / "move.py"}))
    duet.runtime.variables["Untitled-1"] = {"QMIN": [-1.0] * 6, "QMAX": [1.0] * 6, "OTHER": 5.0}
    return duet


def endpoint(duet):
    return items_of(duet.environment.model, "Joint object")[0]


def test_a_robots_bounds_are_known_as_soon_as_it_lives(duet):  # R-D08
    assert endpoint(duet).low is None
    doc = duet.connected("arm")
    assert live.Read("Untitled-1", ("QMAX", "QMIN")) in duet.carried_out
    assert (endpoint(duet).low, endpoint(duet).high) == ((-1.0,) * 6, (1.0,) * 6)
    assert duet.environment.tree.types["Joint object"].items[0].high == (1.0,) * 6
    duet.do(act.Disconnect(doc))
    count = len(duet.carried_out)
    duet.environment.become(lambda model: Done(replace(model, limits={})))
    duet.do(act.Connect(doc))  # it lives already, and tells nothing by itself
    assert live.Read("Untitled-1", ("QMAX", "QMIN")) in duet.carried_out[count:]
    assert endpoint(duet).low == (-1.0,) * 6


def test_a_runtime_that_does_not_say_them_is_no_harm(duet):
    duet.rebuffs = {live.Read: request.Refused(Reason.plain("no"))}
    duet.connected("arm")
    assert endpoint(duet).low is None


def test_a_task_that_tells_no_bounds_is_asked_for_nothing(duet):
    duet.connected("move")
    assert not any(isinstance(message, live.Read) for message in duet.carried_out)
