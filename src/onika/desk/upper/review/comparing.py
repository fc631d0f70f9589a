"""Another recorded run beside the one that is looked at, and where the two begin to differ (requirement X05)."""

from dataclasses import replace

from msgspec import structs

from onika.desk.environment.aside import Outcome
from onika.desk.environment.model import Model
from onika.desk.environment.outcome import Done, No
from onika.desk.environment.surroundings import Surroundings
from onika.desk.upper.review.looking import Looking
from onika.desk.upper.review.opening import NOT_HERE, put_one_away, read
from onika.desk.upper.review.subject import Subject
from onika.record.difference import Difference, first_difference
from onika.record.reader import UNREADABLE, Reader
from onika.record.tolerance import Tolerance
from onika.wire import act
from onika.wire.view import DifferenceView

EXACT = Tolerance()
WALL = Tolerance(0.005, 0.01, 0.05)
"""Between two runs of the same program in wall time."""


def compare_with(model: Model, asked: act.CompareWith, outside: Surroundings) -> Done | No:
    """Show another one beside it; the value is its path. The difference comes later, with the tree."""
    reading, comparing = outside.reading, outside.comparing
    if reading is None or comparing is None:
        return NOT_HERE
    if model.looking is None:
        return No("no recording is looked at: open one first")
    if wrong := _negative(asked):
        return No("a tolerance is 0 or more", fields=wrong)
    if not asked.path:
        put_one_away(model.looking.other, reading)
        return Done(replace(model, looking=Looking(model.looking.subject)))

    def adopted(model: Model, found: Subject) -> Done | No:
        if model.looking is None:
            put_one_away(found, reading)
            return No("the recording was put away meanwhile")
        put_one_away(model.looking.other, reading)
        one = model.looking.subject
        tolerance = _tolerance(asked, one, found)
        order = comparing.order(lambda: _compared(one, found, tolerance))
        return Done(replace(model, looking=Looking(one, found)), value=found.view.path, orders=(order,))

    return read(model, asked.path, outside, reading, adopted, opens=False)


def _negative(asked: act.CompareWith) -> dict[str, str]:
    return {name: "expected 0 or more" for name in ("tolerance", "part", "time_s") if (getattr(asked, name) or 0) < 0}


def _tolerance(asked: act.CompareWith, one: Subject, other: Subject) -> Tolerance:
    """As asked; else two runs of the simulator may not differ at all, and in wall time no run is like another."""
    usual = EXACT if one.view.is_virtual and other.view.is_virtual else WALL
    return Tolerance(
        usual.value if asked.tolerance is None else asked.tolerance,
        usual.part if asked.part is None else asked.part,
        usual.seconds if asked.time_s is None else asked.time_s,
    )


def _compared(one: Subject, other: Subject, tolerance: Tolerance) -> Outcome:
    """Both files are read anew, so that nobody waits who looks at them meanwhile."""
    found: Difference | None = None
    wrong = ""
    try:
        readers = Reader(one.path), Reader(other.path)
        found = first_difference(*readers, tolerance, lambda: not (one.away.is_set() or other.away.is_set()))
        for reader in readers:
            reader.close()
    except UNREADABLE as fault:
        wrong = f"the two recordings cannot be compared: {fault}"

    def told(model: Model) -> Done:
        looking = model.looking
        if looking is None or looking.subject is not one or looking.other is not other:
            return Done(model)
        difference = DifferenceView(wrong) if wrong else _view(found, one)
        difference = structs.replace(
            difference, tolerance=tolerance.value, part=tolerance.part, time_s=tolerance.seconds
        )
        return Done(replace(model, looking=replace(looking, difference=difference)))

    return told


def _view(found: Difference | None, one: Subject) -> DifferenceView:
    if found is None:
        return DifferenceView()
    text = one.said(f"{found.what}: {found.first}, in the other {found.second}")
    return DifferenceView(text, found.at_ns * 1e-9, found.variable)
