"""What is looked at: a recorded run, and another one beside it."""

from collections.abc import Container
from dataclasses import dataclass

from msgspec import structs

from onika.desk.environment.run_state.recorded_run import ReviewedRun
from onika.wire.view import DifferenceView, RecordingView, ReviewView


@dataclass(frozen=True, slots=True)
class ReviewSession:
    """A recorded run that is looked at; `difference` is None while it is looked for, or where there is no other."""

    subject: ReviewedRun
    other: ReviewedRun | None = None
    difference: DifferenceView | None = None

    def view(self, docs: Container[str]) -> ReviewView:
        """As a page shows it; an application that was closed meanwhile is not named."""
        other = _of(self.other.view, docs) if self.other else None
        return ReviewView(_of(self.subject.view, docs), other, self.difference)

    def address_in_other(self, variable: str) -> str:
        """A variable of the first one as it is called in the other: what was held by hand may have another name."""
        if self.other is None or variable in self.other.review.series:
            return variable
        runs = (self.subject.review.run, self.other.review.run)
        if not all(run.is_by_hand for run in runs):
            return variable
        name = variable.rpartition("/")[2]
        return next((address for address, series in self.other.review.series.items() if series.name == name), variable)

    def subject_of(self, *, of_other: bool) -> ReviewedRun | None:
        """One of the two; None: there is no other."""
        return self.other if of_other else self.subject


def _of(recording: RecordingView, docs: Container[str]) -> RecordingView:
    if recording.doc in docs:
        return recording
    return structs.replace(recording, doc="")
