import numpy as np

from onika.host.run.run_statistics import RunStatistics
from onika.ring.segment import Segment
from onika.runtime.news import Statuses, TaskStatus
from onika.runtime.table import SIZE, Table
from onika.words.reason import NOTHING, Reason
from onika.words.shape import Shape


def table(**values):
    made = Table(Segment.create("table", SIZE))
    for name, value in values.items():
        array = np.asarray(value, dtype=float)
        made.entry(name, Shape.parse("double" if array.ndim == 0 else f"double[{len(array)}]"))
        made.ring(name).write(array.tobytes())
    return made


def status(subsystem, task, **changes):
    numbers = {"cycle": 10, "miss": 1, "warn": 0, "reference_hz": 100.0, "measured_hz": 99.0, "profiled_s": 1.0}
    times = {"total_us": 50.0, "least_us": 1.0, "mean_us": 5.04, "most_us": 9.96}
    return TaskStatus(subsystem, task, task, "ON", "periodic", 0, **(numbers | times | changes))


def test_watched_variables_are_read_by_subsystem_or_from_the_first_that_has_them():  # R-E11
    statistics = RunStatistics(("X", "flow1/X", "Y", "flow0/Y", "NOBODY", "flow7/X"))
    statistics.read({"flow0": table(X=1.0), "flow1": table(X=2.0, Y=[3.0, 4.0])})
    assert statistics.values == {"X": 1.0, "flow1/X": 2.0, "Y": [3.0, 4.0]}


def test_what_was_never_written_reads_as_zero():
    statistics = RunStatistics(("X",))
    made = Table(Segment.create("table", SIZE))
    made.entry("X", Shape.parse("int"))
    statistics.read({"flow0": made})
    assert statistics.values == {"X": 0}


def test_a_switch_lasts_from_the_finish_to_the_first_cycle_after_it():  # R-A07
    statistics = RunStatistics(())
    statistics.first_cycle(0, 1_000)  # no finish before it: the beginning of the run
    statistics.finished(0, 5_000)
    statistics.finished(1, 6_000)
    statistics.first_cycle(0, 7_500)
    statistics.first_cycle(0, 9_000)  # another task of the same action
    statistics.first_cycle(1, 6_250)
    assert statistics.result(2, 0.0, "").switches_us == (2.5, 0.25)


def test_only_the_first_end_counts():  # R-E14
    statistics = RunStatistics(())
    statistics.began_at = 1_000_000_000
    statistics.done = 3
    statistics.end(False, Reason.plain("somebody fell"), 3_500_000_000)
    statistics.end(True, NOTHING, 9_000_000_000)
    result = statistics.result(5, 1.25, "abc")
    assert (result.completed, str(result.cause), result.done, result.of) == (False, "somebody fell", 3, 5)
    assert (result.runtime_s, result.wall_s, result.hash) == (2.5, 1.25, "abc")


def test_figures_of_all_units_are_told_in_order():  # R-A17
    statistics, flows = RunStatistics(()), ("flow0", "flow1")
    statistics.figures(Statuses("rt1", 0.1, (status("flow1", "a"), status("flow0", "z"))), flows)
    statistics.figures(Statuses("rt0", 0.1, (status("flow0", "b", miss=4),)), flows)
    statistics.figures(Statuses("rt0", 0.1, (status("another", "b"),)), flows)
    tasks = statistics.result(0, 0.0, "").tasks
    assert [(task.subsystem, task.task, task.rtpu, task.missed) for task in tasks] == [
        ("flow0", "b", "rt0", 4),
        ("flow0", "z", "rt1", 1),
        ("flow1", "a", "rt1", 1),
    ]
    assert (tasks[0].hz, tasks[0].cycles, tasks[0].mean_us, tasks[0].most_us) == (100.0, 10, 5.0, 10.0)


def test_figures_add_up_whoever_asks_for_statuses_meanwhile():  # R-A17
    statistics = RunStatistics(())
    for missed in (1, 4):
        statistics.figures(Statuses("rt0", 0.1, (status("flow0", "b", miss=missed),)), ("flow0",))
    task = statistics.result(0, 0.0, "").tasks[0]
    assert (task.cycles, task.missed, task.mean_us, task.most_us) == (20, 5, 5.0, 10.0)


def test_flows_that_begin_together_are_told_when_the_last_of_them_has_cycled():  # R-X03
    statistics = RunStatistics(())
    statistics.meets("meet", (0, 2))
    assert statistics.first_cycle(2, 5_000) is None
    assert statistics.first_cycle(1, 6_000) is None
    met = statistics.first_cycle(0, 17_500)
    assert (met.tag, met.flows, met.skew_us) == ("meet", (0, 2), 12.5)
    assert statistics.first_cycle(0, 20_000) is None
    assert statistics.result(1, 0.0, "").skews_us == (12.5,)


def test_who_has_waited_has_not_switched():  # R-X03
    statistics = RunStatistics(())
    statistics.finished(0, 1_000)
    statistics.meets("meet", (0, 1))
    statistics.first_cycle(0, 9_000)
    assert statistics.result(1, 0.0, "").switches_us == ()
