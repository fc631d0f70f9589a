from onika.wire import event
from onika.wire.figures import VariableSteps
from onika.words.reason import NOTHING


def stepped(step=40.0, cycles=6, limit=9.76, variable="TAU_REF"):
    return event.Stepped("main", "puma", variable, "N m", 1, step, 9.0, limit, cycles, 2.5)


def test_before_anything_is_exchanged_there_is_nothing_to_say(sit):  # R-X04
    assert sit().does("jumps")[0].startswith("no step was told yet")


def test_the_last_step_of_each_variable_is_a_row(sit):  # R-X04
    sitting = sit()
    for message in (stepped(1.0, 0), stepped(), stepped(3.0, 0, 0.0, "LEVEL"), stepped(900.0, 0, variable="X")):
        sitting.runtime.tell(message)
    sitting.session.hear()
    head, *rows = sitting.does("jumps")
    assert head.split() == ["variable", "step", "of", "share/%", "unit", "at/s", "became"]
    assert [row.split(maxsplit=6) for row in rows] == [
        ["main/LEVEL[1]", "3", "-", "-", "N", "m", "2.50  passed on"],
        ["main/TAU_REF[1]", "40", "9.76", "410", "N", "m", "2.50  blended over 6 cycles"],
        ["main/X[1]", "900", "9.76", "9221", "N", "m", "2.50  refused"],
    ]
    assert sitting.does("jumps left")[0].startswith("no step was told yet")


def test_of_a_run_the_largest_is_told_when_it_is_over(sit):  # R-X04, R-E14
    sitting = sit()
    steps = (VariableSteps("flow0", "puma", "TAU_REF", "N m", 19, 1, 3.4, 3.4, 18.6, 21.2),)
    sitting.runtime.tell(event.Result(True, NOTHING, 1, 1, 2.0, 2.0, {}, (), "", steps=steps))
    sitting.session.hear()
    assert sitting.does("jumps flow0")[1].endswith("21.20  passed on, the largest of 19")
