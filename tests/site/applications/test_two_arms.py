"""Two arms in one workcell put the boxes together, each in a flow of its own; tags keep them apart (K02)."""

import json

import pytest

from kit.runtime.direct_client import OpenGate
from kit.worlds.box_cells import boxes_world
from onika.cli import main
from onika.desk.plan.preparation import prepare_run
from onika.host.loading.module_facts import ModuleFacts
from onika.host.loading.plan_preparation import prepare
from onika.host.program import RuntimeProgram
from onika.host.units.virtual import VirtualDriver
from onika.store.site import open_site
from onika.wire import event, request

pytestmark = pytest.mark.site

TAGS = {"triangle": (10, 5), "square": (13, 10), "cross": (17, 11)}
"""The actions of the left and of the right arm that begin together."""


def told_of(capsys, *words):
    code = main(["run", "assemble_together", "--expect", "LAMP == 1", "--json", *words])
    events = [json.loads(line) for line in capsys.readouterr().out.splitlines() if line.startswith("{")]
    return code, events


WALL = pytest.param(["--no-fifo"], id="wall", marks=pytest.mark.slow)  # as long as the arms move


@pytest.mark.parametrize("time", [pytest.param(["--virtual"], id="virtual"), WALL])
def test_two_arms_put_the_boxes_together_and_meet_at_every_tag(capsys, time):  # R-K02, R-E04
    code, events = told_of(capsys, *time)
    result = events[-1]
    assert (code, result["state"], result["values"]) == (0, "completed", {"LAMP": 1})
    assert (result["actions_done"], result["actions"]) == (30, 30)
    begun, done = (
        {(entry["flow"], entry["index"]): entry["at_s"] for entry in events if entry["event"] == kind}
        for kind in ("began", "done")
    )
    for tag, (left, right) in TAGS.items():
        here, there = begun[0, left], begun[1, right]
        assert min(here, there) >= max(done[0, left - 1], done[1, right - 1]), tag
        assert here == there or "--virtual" not in time, tag


@pytest.mark.parametrize("seed", range(3))
def test_boxes_that_stand_a_millimetre_elsewhere_are_put_together_as_well(seed):  # R-K02
    planned = prepare_run("assemble_together", open_site([], {}, None))
    assert planned.faults == ()
    server = OpenGate()
    driver = VirtualDriver(("rt0",), server.tell, worlds=lambda _name: boxes_world(seed))
    program = RuntimeProgram(server, driver, ModuleFacts(), ("rt0",))
    program.applications.take("me", prepare(planned.plan, planned.targets, ModuleFacts()))
    program.applications.begin("me", request.Begin(watch=("LAMP",)))
    while program.advance(1_000_000_000):
        pass
    result = server.events[-1]
    assert isinstance(result, event.Result)
    assert (result.completed, result.values["LAMP"]) == (True, 1)
