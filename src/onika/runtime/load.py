"""The load of a processing unit: what its tasks cost, and whether one more is too much for EDF (requirement X13)."""

from collections.abc import Iterable
from dataclasses import dataclass

from msgspec import Struct

from onika.words.reason import NOTHING, Reason

MARGIN = 0.9
"""Above this share the unit's own work, which is no task's, begins to make cycles late."""


class TaskLoad(Struct, frozen=True):
    """What one task costs: its rate in hertz, and the mean and longest time of a cycle in microseconds.

    `cycles` says how many cycles that was measured over; 0: nothing is known of it, or it was assumed.
    """

    subsystem: str
    task: str
    is_on: bool
    hz: float
    mean_us: float
    most_us: float
    cycles: int = 0

    @property
    def use(self) -> float:
        """The share of the unit's time that it takes in the mean: U = C / period."""
        return self.mean_us * 1e-6 * self.hz


@dataclass(frozen=True, slots=True)
class Prediction:
    """The predicted utilisation of a unit, and the sentence that says why it is too much; empty where it is not."""

    use: float
    warning: Reason


def use_of(tasks: Iterable[TaskLoad]) -> float:
    """The share of a unit's time that its tasks take while they are ON."""
    return sum(task.use for task in tasks if task.is_on)


def predict(rtpu: str, tasks: Iterable[TaskLoad], more: TaskLoad, margin: float = MARGIN) -> Prediction:
    """What the unit's utilisation would be with one more task ON; the same task among `tasks` is replaced by it."""
    others = [task for task in tasks if (task.subsystem, task.task) != (more.subsystem, more.task)]
    before = use_of(others)
    use = before + more.use
    if use <= margin:
        return Prediction(use, NOTHING)
    adds = Reason.of(
        "runtime.adds_load",
        task=more.task,
        mean_us=more.mean_us,
        hz=more.hz,
        more=more.use,
        before=before,
        rtpu=rtpu,
        use=use,
    )
    if use > 1.0:
        return Prediction(use, Reason.of("runtime.more_than_all", adds=adds))
    return Prediction(use, Reason.of("runtime.above_margin", adds=adds, margin=margin))
