from kit import build
from onika.engine import orders
from onika.host.run.run_events import Herald
from onika.host.run.run_statistics import Meeting
from onika.model.lifecycle import State
from onika.runtime import news
from onika.wire import event


class Named:
    def __init__(self, name):
        self.name = name


def heard(*what):
    told = []
    plan = build.plan([build.job("move", trigger="move")], [build.job("move", trigger="move")])
    herald = Herald(plan, {0: Named("left"), 1: Named("right")}, told.append)
    herald.began = 1_000_000_000
    for tell in what:
        tell(herald)
    (one,) = told
    return one


def test_an_action_is_told_with_its_name_and_how_many_there_are():  # R-E11
    one = heard(lambda herald: herald.order(orders.Began(1, 0), 1_500_000_000))
    assert one == event.Began(1, 0, 1, "action 0", 0.5)
    assert heard(lambda herald: herald.order(orders.Done(1, 0), 1_500_000_000)) == event.Done(1, 0, 0.5)


def test_a_flow_that_waits_is_told_with_the_names_of_those_it_waits_for():  # R-X03
    moved = orders.Moved(0, "waiting", 3, "meet", (1,), "flow 1 has ended")
    one = heard(lambda herald: herald.order(moved, 1_000_000_000))
    assert one == event.Moved("left", "waiting", 3, 0.0, "meet", ("right",), "flow 1 has ended")


def test_notes_and_warnings_name_their_subsystem():  # R-A08
    assert heard(lambda herald: herald.order(orders.Note(1, "so"), 1_000_000_000)) == event.Warned("right", "", "so", 0)
    assert heard(lambda herald: herald.warned(0, "arm", "hot", 1_000_000_000)) == event.Warned("left", "arm", "hot", 0)


def test_states_meetings_and_failures_are_told_in_the_time_of_the_run():  # R-E11, R-A18
    one = heard(lambda herald: herald.state(0, "arm", State.ON, 1_250_000_000))
    assert one == event.TaskState("left", "arm", "ON", 0.25)
    met = heard(lambda herald: herald.met(Meeting("meet", (0, 1), 12.5), 2_000_000_000))
    assert met == event.Met("meet", ("left", "right"), 12.5, 1.0)
    failed = news.Failed("left", "arm", "cycle", "no", "arm.py", 7, "trace", 1_125_000_000, values={"X": 1})
    told = heard(lambda herald: herald.failed(failed))
    assert (told.text, told.line, told.at_s, told.values) == ("cycle: no", 7, 0.125, {"X": 1})
