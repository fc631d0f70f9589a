"""One run of a sweep: its seed, the numbers that were drawn for it, and what came of it (requirement X23)."""

from typing import Literal

from msgspec import Struct

from onika.words.reason import NOTHING, Reason

State = Literal["completed", "aborted", "refused", "lost"]


class Case(Struct, frozen=True):
    """A run that is to be made."""

    seed: int
    values: dict[str, float] = {}


class CaseResult(Struct, frozen=True):
    """What came of one; a line of the file of results."""

    case: Case
    state: State
    cause: Reason = NOTHING
    """Why it did not come to its end."""
    unmet: tuple[str, ...] = ()
    """The expectations that do not hold at its end."""
    lasted_s: float = 0.0
    hash: str = ""

    @property
    def is_good(self) -> bool:
        """Whether it came to its end, and all that was expected of it holds."""
        return self.state == "completed" and not self.unmet

    @property
    def failure(self) -> Reason:
        """What went wrong first; NOTHING: nothing."""
        if self.cause:
            return self.cause
        return Reason.of("sweep.unmet", expectation=self.unmet[0]) if self.unmet else NOTHING
