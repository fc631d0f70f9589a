from kit.engine.play_lines import JOB, NOOP
from kit.plans import build
from kit.plans.flow_program import bottom, nested, program
from onika.engine.flow import FlowEvent, FlowState
from onika.engine.flow_router import FlowRouter
from onika.engine.orders import Began, Moved, Settle, Switch, Together
from onika.engine.program import FlowProgram
from onika.engine.progress import Progress
from onika.engine.step import steps
from onika.wire.plan import Do, Halt

MEET = build.job("move", trigger="move", synch_tag="meet")


def begun(*flows):
    """The flows of a plan, all of whose tasks live, and their router."""
    plan = build.plan(*flows)
    made = []
    for number, planned in enumerate(plan.flows):
        ranks = {"move": 0}
        triggers = {index: None if action.is_noop else "move" for index, action in enumerate(planned.actions)}
        ready = steps(planned, triggers, set(), ranks)
        made.append(Progress(number, planned, FlowProgram(planned), ready, ranks, lambda _condition: False))
        made[-1].enter(FlowEvent.SPAWN)
        made[-1].flow_tasks.spawn()
        if planned.parent is not None:
            made[-1].enter(FlowEvent.COMPLETE)
    return FlowRouter(made, [f"arm{number}" for number in range(len(made))]), made


def kinds(orders):
    return [type(order) for order in orders]


def test_one_flow_that_goes_on_begins_alone():
    router, _ = begun([JOB])
    assert kinds(router.go_on([0])) == [Switch, Began]


def test_flows_that_go_on_at_once_begin_together_after_all_that_is_told():  # R-E04
    router, _ = begun([JOB], [NOOP], [JOB])
    orders = router.go_on([0, 1, 2])
    assert orders[-5] == Together("", (0, 2))
    assert kinds(orders[-4:]) == [Switch, Began, Switch, Began]


def test_a_case_that_was_carried_out_gives_its_number_to_the_switch():
    router, _ = begun([JOB])
    assert router.go_on([0], number=7)[0].number == 7


def test_when_all_flows_are_done_things_settle_and_not_before():  # R-E14
    router, flows = begun([NOOP], [NOOP])
    assert Settle() not in router.go_on([0])
    assert flows[0].state is FlowState.DONE
    assert router.go_on([1])[-1] == Settle()


def test_who_waits_for_whom_is_told_by_number_and_as_a_position_by_subsystem():  # R-X03
    router, flows = begun([MEET], [JOB, MEET], [JOB, MEET])
    router.go_on([0, 1, 2])
    assert router.waits_for(flows[0]) == [1, 2]
    assert router.waits(flows[0]) == Moved(0, "waiting", -1, "meet", (1, 2))
    position = router.position(flows[0])
    assert (position.subsystem, position.tag, position.waits_for) == ("arm0", "meet", ("arm1", "arm2"))
    assert router.waits_for(flows[1]) == []


def test_a_flow_that_is_begun_by_another_has_not_ended_before_that_has():  # reading 26
    parent = build.flow([JOB, JOB], program(nested([(1, 0)], Do(0)), Do(1)))
    router, flows = begun(parent, build.flow([MEET], (), 0), [MEET])
    router.go_on([2])
    flows[0].enter(FlowEvent.BEGIN)
    assert not router.waits(flows[2]).text
    flows[0].enter(FlowEvent.COMPLETE)
    assert str(router.waits(flows[2]).text) == "flow 1 has ended and will not come"


def test_a_flow_waits_for_the_nested_ones_it_awaits_and_for_those_it_would_begin_again():  # R-D13
    script = (*program(nested([(1, 0)]))[:-1], *program(nested([(1, 0)]))[:-1], Do(0), Halt())
    router, flows = begun(build.flow([JOB], script), build.flow([JOB], (), 0))
    router.go_on([0])
    assert (flows[0].state, router.waits_for(flows[0])) == (FlowState.JOINING, [1])
    flows[0].advance()
    router.go_on([0])
    assert (flows[0].state, flows[0].place, router.waits_for(flows[0])) == (FlowState.JOINING, 2, [1])


def test_a_flow_that_rests_is_not_to_pause_any_more():
    router, flows = begun([JOB])
    flows[0].is_pausing = True
    assert router.rest(flows[0]) == [Moved(0, "paused", -1)]
    assert not flows[0].is_pausing


def test_a_position_tells_loops_breakpoints_failures_and_a_pause_to_come():
    router, flows = begun([JOB])
    router.go_on([0])
    flows[0].is_pausing = True
    flows[0].breakpoints = {3: "", 1: "X"}
    flows[0].flow_tasks.has_failed("move")
    position = router.position(flows[0])
    assert (position.state, position.action, position.is_pausing) == ("running", 0, True)
    assert (position.breakpoints, position.failed, position.loops) == ((1, 3), ("move",), ())


def test_a_flow_that_goes_round_without_time_is_astray():
    router, _ = begun(build.flow([NOOP], program(bottom("round", Do(0)))))
    router.go_on([0])
    assert str(router.astray) == "flow 0 goes round for ever without taking any time"
