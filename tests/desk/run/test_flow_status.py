from onika.desk.run.flow_status import FlowStatus
from onika.wire import event, steer


def moved(state, at_s=0.0, **what):
    return event.Moved("flow0", state, 2, at_s, **what)


def test_an_action_is_carried_out_from_its_beginning_until_it_is_done():  # R-E11
    status = FlowStatus().began(event.Began(0, 2, 3, "move", 1.0))
    assert (status.action, status.name, status.is_acting) == (2, "move", True)
    assert not status.done().is_acting


def test_a_flow_waits_since_it_came_to_wait_whatever_more_is_said_of_it():  # R-X03
    status = FlowStatus().moved(moved("waiting", 3.0, tag="meet", waits_for=("flow1",)))
    again = status.moved(moved("waiting", 5.0, tag="meet", waits_for=("flow1", "flow2")))
    assert (again.waits_since_s, again.waits_for) == (3.0, ("flow1", "flow2"))
    assert again.moved(moved("running", 6.0)).waits_since_s == 0.0


def test_what_the_runtime_says_of_a_flow_counts_more_than_what_was_heard():
    status = FlowStatus("running", 0, "move").placed(steer.Position("flow0", "paused", 1))
    assert (status.state, status.action, status.name) == ("paused", 1, "move")
