"""The desired state of a live subsystem: what users want of its tasks from now on, whatever is true at the moment."""

from collections.abc import Collection, Mapping


class DesiredState:
    """By task: with which argument line it is to be ON, at which rate, with which constants."""

    def __init__(self) -> None:
        self._lines: dict[str, str] = {}
        self._rates: dict[str, float] = {}
        self._constants: dict[str, dict[str, int]] = {}
        self._to_reinitialise: set[str] = set()

    def copy(self) -> "DesiredState":
        """The same, to go back to."""
        other = DesiredState()
        other.take_back(self)
        other.take_back_constants(self)
        return other

    def take_back(self, before: "DesiredState") -> None:
        """What is to be ON, and the rates, are again what they were."""
        self._lines, self._rates = dict(before._lines), dict(before._rates)

    def take_back_constants(self, before: "DesiredState") -> None:
        """The stated constants are again what they were."""
        self._constants = {task: dict(values) for task, values in before._constants.items()}

    def forget(self, task: str) -> None:
        """The task is gone."""
        for by_task in (self._lines, self._rates, self._constants):
            by_task.pop(task, None)
        self._to_reinitialise.discard(task)

    # ON

    def is_on(self, task: str) -> bool:
        """Whether it is wanted ON."""
        return task in self._lines

    def line(self, task: str) -> str:
        """Its last argument line."""
        return self._lines.get(task, "")

    def turn_on(self, task: str, line: str) -> None:
        """It is wanted ON, with this argument line."""
        self._lines[task] = line

    def turn_off(self, task: str) -> None:
        """It is not wanted ON any more."""
        self._lines.pop(task, None)

    def turn_everything_off(self) -> None:
        """Nothing is wanted ON."""
        self._lines.clear()

    # Rates

    def rate(self, task: str) -> float | None:
        """Its rate in hertz; None: as it was planned."""
        return self._rates.get(task)

    def set_rate(self, task: str, hz: float) -> None:
        """From now on it is to have this rate."""
        self._rates[task] = hz

    # Constants

    def constants(self, tasks: Collection[str]) -> dict[str, int]:
        """What robot modules among these tasks state before they live."""
        return {svar: value for task in tasks for svar, value in self._constants.get(task, {}).items()}

    def constants_of(self, task: str) -> Mapping[str, int] | None:
        """What this task's module states before it lives; None: nothing."""
        return self._constants.get(task)

    def state_constants(self, task: str, values: Mapping[str, int] | None) -> None:
        """A task's module states these before it lives, or nothing any more."""
        if values:
            self._constants[task] = dict(values)
        else:
            self._constants.pop(task, None)

    # In ERROR when constants have changed

    def reinitialise_later(self, task: str) -> None:
        """It is in ERROR, and constants that it reads have changed: it is initialised when it is cleared."""
        self._to_reinitialise.add(task)

    def is_to_be_reinitialised(self, task: str) -> bool:
        """Whether it takes over its constants when it is cleared."""
        return task in self._to_reinitialise

    def is_reinitialised(self, task: str) -> None:
        """It takes over its constants now."""
        self._to_reinitialise.discard(task)
