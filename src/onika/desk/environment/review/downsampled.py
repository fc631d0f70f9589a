"""The course of a variable over a recorded run, as it is plotted (requirement X05).

All its values are read once, aside; then any stretch of it is answered at once.
"""

from msgspec import structs

from onika.desk.environment.outcome.outcome import Done, No, Procedure, Work
from onika.desk.environment.outcome.services import Services
from onika.desk.environment.review.opening import NOT_HERE
from onika.desk.environment.review.snapshot import looked_at, sane, spoilt
from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.desk.environment.state.model import Model
from onika.desk.run.run_review import drawn
from onika.record import downsampled as recorded
from onika.record.downsampled import Samples
from onika.record.reader import UNREADABLE
from onika.record.series import Series
from onika.wire import act
from onika.wire.view import StretchView
from onika.words.reason import Reason

_MOST_POINTS = 4000


def course(model: Model, command: act.Course, outside: Services) -> Procedure:
    """A variable over a stretch of the run; the value is a tuple of `view.StretchView`, empty for what is no number."""
    subject = looked_at(model, of_other=command.of_other)
    if isinstance(subject, No):
        return subject
    if command.of_other and model.review_session is not None:
        command = structs.replace(command, variable=model.review_session.address_in_other(command.variable))
    aside, series = outside.reading, subject.review.series.get(command.variable)
    if aside is None:
        return NOT_HERE
    if series is None:
        return No(Reason.of("run.not_recorded", variable=command.variable, name=subject.path.name))
    if not recorded.is_drawn(series):
        return Done(model, value=())
    samples = subject.samples.get(command.variable)
    if samples is not None:
        return Done(model, value=_stretches(subject, command, samples))

    model, samples = yield Work(model, aside, lambda: _read(subject, command.variable, series))
    if isinstance(samples, No):
        return samples
    return Done(model, value=_stretches(subject, command, samples))


def _read(subject: ReviewedRun, variable: str, series: Series) -> Samples | No:
    """All the values of a variable, kept for the next time."""
    samples = subject.samples.get(variable)
    try:
        samples = samples or recorded.samples(series)
    except UNREADABLE as wrong:
        return spoilt(subject, wrong)
    subject.samples.put(variable, samples)
    return samples


def _stretches(subject: ReviewedRun, command: act.Course, samples: Samples) -> tuple[StretchView, ...]:
    begin = round(sane(command.begin_s) * 1e9)
    end = max(round(sane(command.end_s) * 1e9), begin)
    some = recorded.parts(samples, begin, end, min(max(command.points, 1), _MOST_POINTS))
    return tuple(
        StretchView(course.label, course.unit, tuple(course.at_s), tuple(course.least), tuple(course.most))
        for course in drawn(subject.review.series[command.variable], some)
    )
