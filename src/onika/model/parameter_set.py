"""A parameter set: values of parameters of several tasks under one name, to be compared and switched."""

from collections.abc import Iterable
from dataclasses import dataclass

from onika.model.task import LocalLine

Values = tuple[tuple[str, LocalLine], ...]
"""Tasks, each with one line of its LOCAL block; a task comes as often as it has lines."""


@dataclass(frozen=True, slots=True)
class ParameterSet:
    """Parameters of tasks, each once."""

    name: str
    values: Values

    def of_task(self, task: str) -> dict[str, tuple[str, ...]]:
        """The words of a task's parameters by their names."""
        return {line.key: line.words for name, line in self.values if name == task}

    @property
    def tasks(self) -> tuple[str, ...]:
        """Whose parameters it holds, each once, in their order."""
        return tuple(dict.fromkeys(name for name, _ in self.values))


def merged(lines: Iterable[LocalLine], words: dict[str, tuple[str, ...]]) -> tuple[LocalLine, ...]:
    """The lines of a LOCAL block with these words; a parameter without a line gets one behind them."""
    present = tuple(lines)
    keys = {line.key for line in present}
    changed = tuple(LocalLine(line.key, words.get(line.key, line.words)) for line in present)
    return (*changed, *(LocalLine(key, given) for key, given in words.items() if key not in keys))
