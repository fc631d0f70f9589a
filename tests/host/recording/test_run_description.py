from kit.plans.plan_builder import action
from kit.runtime.direct_client import DirectClient
from kit.worlds.rail_world import rail_tasks
from onika.host.recording.run_description import RunDescriptions
from onika.wire import request

PREPARE = request.Prepare(rail_tasks().plan([action("mass", "servo", arguments="1.0")]), ())


def descriptions():
    desk = DirectClient(("rt0", "rt1"))
    described = RunDescriptions(desk.program.subsystems, desk.driver)
    described.keep("me", PREPARE)
    return described


def test_a_run_is_described_by_what_was_prepared_and_asked():  # law 29
    run = descriptions().describe("me", request.Begin(seed=4, record="/x", is_held=True))
    assert (run.prepare, run.rtpus, run.is_virtual) == (PREPARE, ("rt0", "rt1"), True)
    assert run.begin == request.Begin(seed=4)


def test_only_the_first_run_is_fresh():  # law 29
    described = descriptions()
    assert described.describe("me", request.Begin()).is_fresh
    described.began()
    assert not described.describe("me", request.Begin()).is_fresh


def test_of_whom_nothing_is_known_nothing_is_described():  # law 29
    described = descriptions()
    assert described.describe("other", request.Begin()) is None
    described.lost("me")
    assert described.describe("me", request.Begin()) is None
