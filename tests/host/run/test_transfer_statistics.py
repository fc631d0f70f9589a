from onika.host.run.transfer_statistics import TransferStatistics
from onika.runtime.news import Stepped


def stepped(step, limit=10.0, cycles=0, subsystem="flow0", at_ns=3_000_000_000, variable="TAU"):
    return Stepped(subsystem, "arm", variable, "N m", 1, step, min(step, limit or step), limit, cycles, at_ns)


def test_the_largest_step_stands_for_all_and_they_are_counted():  # R-X04
    strides = TransferStatistics()
    for step in (stepped(3.0), stepped(25.0, cycles=6), stepped(4.0), stepped(12.0, cycles=4), stepped(900.0)):
        strides.note(step)
    (figure,) = strides.figures(1_000_000_000)
    assert (figure.subsystem, figure.task, figure.variable, figure.unit) == ("flow0", "arm", "TAU", "N m")
    assert (figure.count, figure.index, figure.step, figure.given, figure.limit) == (5, 1, 900.0, 10.0, 10.0)
    assert (figure.blended, figure.cycles, figure.refused, figure.at_s) == (2, 6, 1, 2.0)


def test_the_largest_is_the_largest_share_of_what_it_may_be():  # R-X04
    strides = TransferStatistics()
    strides.note(stepped(5.0, limit=100.0))
    strides.note(stepped(4.0, limit=10.0))
    assert strides.figures(0)[0].step == 4.0


def test_without_a_limit_nothing_was_too_far():  # R-X04
    strides = TransferStatistics()
    strides.note(stepped(5.0, limit=0.0))
    (figure,) = strides.figures(0)
    assert (figure.step, figure.limit, figure.blended, figure.refused) == (5.0, 0.0, 0, 0)


def test_variables_are_told_by_subsystem_and_name():  # R-X04
    strides = TransferStatistics()
    for subsystem, variable in (("flow1", "A"), ("flow0", "B"), ("flow0", "A")):
        strides.note(stepped(1.0, subsystem=subsystem, variable=variable))
    assert [(figure.subsystem, figure.variable) for figure in strides.figures(0)] == [
        ("flow0", "A"), ("flow0", "B"), ("flow1", "A"),
    ]  # fmt: skip
    assert TransferStatistics().figures(0) == ()
