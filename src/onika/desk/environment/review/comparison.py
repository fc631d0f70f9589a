"""Another recorded run beside the one that is looked at, and where the two begin to differ (requirement X05)."""

from collections.abc import Callable
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.outcome.outcome import Done, No, Procedure
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.review.opening import NOT_HERE, put_one_away, read
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.run_state.review_session import ReviewSession
from onika.desk.environment.state.model import Model
from onika.record.difference import SHAPE, Difference, first_difference
from onika.record.reader import UNREADABLE, Reader
from onika.record.tolerance import Tolerance, usual
from onika.wire import act
from onika.wire.view import DifferenceView
from onika.words.reason import NOTHING, Reason, reason_of
from onika.words.shape import Shape


def compare_with(model: Model, command: act.CompareWith, outside: Services) -> Procedure:
    """Show another one beside it; the value is its path. The difference comes later, with the tree."""
    reading, comparing = outside.reading, outside.comparing
    if reading is None or comparing is None:
        return NOT_HERE
    if model.review_session is None:
        return No(Reason.of("run.none_looked_at_open"))
    if wrong := _negative(command):
        return No(Reason.of("run.tolerance_sign"), fields=wrong)
    if not command.path:
        put_one_away(model.review_session.other, reading)
        return Done(replace(model, review_session=ReviewSession(model.review_session.subject)))
    model, other = yield from read(model, command.path, outside, reading, opens=False)
    if isinstance(other, No):
        return other
    if model.review_session is None:
        put_one_away(other, reading)
        return No(Reason.of("run.put_away"))
    put_one_away(model.review_session.other, reading)
    subject = model.review_session.subject
    is_virtual = subject.view.is_virtual and other.view.is_virtual
    tolerance = usual(is_virtual, command.tolerance, command.part, command.time_s)
    comparing.do(lambda: comparing.tell(_compared(subject, other, tolerance)))
    return Done(replace(model, review_session=ReviewSession(subject, other)), value=other.view.path)


def _negative(command: act.CompareWith) -> dict[str, Reason]:
    names = ("tolerance", "part", "time_s")
    return {name: Reason.of("run.zero_or_more") for name in names if (getattr(command, name) or 0) < 0}


def _compared(subject: ReviewedRun, other: ReviewedRun, tolerance: Tolerance) -> Callable[[Model], Done]:
    """Both files are read anew, so that nobody waits who looks at them meanwhile."""
    first: Difference | None = None
    wrong = NOTHING
    try:
        readers = Reader(subject.path), Reader(other.path)
        first = first_difference(*readers, tolerance, lambda: not (subject.away.is_set() or other.away.is_set()))
        for reader in readers:
            reader.close()
    except UNREADABLE as fault:
        wrong = Reason.of("run.not_compared", why=reason_of(fault))

    def with_difference(model: Model) -> Done:
        review_session = model.review_session
        if (
            review_session is None
            or not review_session.subject.is_of(subject)
            or review_session.other is None
            or not review_session.other.is_of(other)
        ):
            return Done(model)
        difference = DifferenceView(wrong) if wrong else _view(first, subject)
        difference = structs.replace(
            difference,
            tolerance=tolerance.value,
            part=tolerance.part,
            time_s=tolerance.seconds,
            is_of_places=tolerance.is_of_places,
        )
        return Done(replace(model, review_session=replace(review_session, difference=difference)))

    return with_difference


def _numbers(difference: Difference, unit: str) -> tuple[str, str] | None:
    """Two numbers with their unit, and as many digits as tell them apart; None: they are something else."""
    try:
        first, second = float(str(difference.first)), float(str(difference.second))
    except ValueError:
        return None
    pairs = ((f"{first:.{digits}g}", f"{second:.{digits}g}") for digits in range(4, 17))
    pair = next((pair for pair in pairs if pair[0] != pair[1]), (str(difference.first), str(difference.second)))
    behind = f" {unit}" if unit not in ("", "-") else ""
    return f"{pair[0]}{behind}", f"{pair[1]}{behind}"


def _side(side: Reason, subject: ReviewedRun) -> Reason:
    """What one of the two says: an action by its icon, the type of an array by how many values there are."""
    if side.key != SHAPE:
        return _with_icon(side, subject)
    dims = Shape.parse(str(side.args["shape"])).dims
    if not dims:
        return side
    return Reason.of("run.values_of_shape", shape=" × ".join(map(str, dims)))


def _with_icon(side: Reason, subject: ReviewedRun) -> Reason:
    """An event; an action that begins is called by what its icon shows."""
    event = side.args.get("event")
    if not isinstance(event, Reason) or event.key != "record.action_begins":
        return side
    icon = subject.wording.actions.get(str(event.args["action"]))
    if icon is None:
        return side
    return Reason.of("record.event_at", event=Reason.of("run.icon_begins", icon=icon), at_s=side.args["at_s"])


def _view(difference: Difference | None, subject: ReviewedRun) -> DifferenceView:
    if difference is None:
        return DifferenceView()
    series = subject.review.series.get(difference.variable)
    numbers = _numbers(difference, series.unit if series else "")
    first, second = numbers or (_side(difference.first, subject), _side(difference.second, subject))
    reason = Reason.of("run.differs", what=difference.what, first=first, second=second)
    return DifferenceView(reason, difference.at_ns * 1e-9, difference.variable)
