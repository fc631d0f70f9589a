"""The strides of a run: how far the inputs of its hardware tasks have stepped where what drives them changed (X04)."""

from onika.runtime import news
from onika.wire.figures import VariableSteps


class TransferStatistics:
    """By variable: how often it was measured, and the step that was the largest share of what it may be."""

    def __init__(self) -> None:
        self._largest: dict[tuple[str, str], news.Stepped] = {}
        self._counts: dict[tuple[str, str], list[int]] = {}

    def note(self, message: news.Stepped) -> None:
        """One more."""
        key = message.subsystem, message.variable
        before = self._largest.get(key)
        if before is None or _share(message) > _share(before):
            self._largest[key] = message
        counts = self._counts.setdefault(key, [0, 0, 0, 0])
        is_too_far = 0.0 < message.limit < message.step
        counts[0] += 1
        counts[1] += message.cycles > 0
        counts[2] = max(counts[2], message.cycles)
        counts[3] += is_too_far and not message.cycles

    def figures(self, began_at: int) -> tuple[VariableSteps, ...]:
        """All of them, by subsystem and variable; times count from the run's start."""
        return tuple(_figures(self._largest[key], self._counts[key], began_at) for key in sorted(self._largest))


def _share(message: news.Stepped) -> float:
    return message.step / (message.limit or 1.0)


def _figures(largest: news.Stepped, counts: list[int], began_at: int) -> VariableSteps:
    count, blended, cycles, refused = counts
    return VariableSteps(
        subsystem=largest.subsystem,
        task=largest.task,
        variable=largest.variable,
        unit=largest.unit,
        count=count,
        index=largest.index,
        step=largest.step,
        given=largest.given,
        limit=largest.limit,
        at_s=round((largest.at_ns - began_at) * 1e-9, 9),
        blended=blended,
        cycles=cycles,
        refused=refused,
    )
