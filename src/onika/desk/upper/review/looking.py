"""What is looked at: a recorded run, and another one beside it."""

from dataclasses import dataclass

from onika.desk.upper.review.subject import Subject
from onika.wire.view import DifferenceView, ReviewView


@dataclass(frozen=True, slots=True)
class Looking:
    """A recorded run that is looked at; `difference` is None while it is looked for, or where there is no other."""

    subject: Subject
    other: Subject | None = None
    difference: DifferenceView | None = None

    @property
    def view(self) -> ReviewView:
        """As a page shows it."""
        return ReviewView(self.subject.view, self.other.view if self.other else None, self.difference)

    def one(self, *, of_other: bool) -> Subject | None:
        """One of the two; None: there is no other."""
        return self.other if of_other else self.subject
