"""Outcomes: what has become of tasks since a transaction last wanted something of them."""

from collections.abc import Iterable, Mapping

from onika.model.lifecycle import State
from onika.words.reason import NOTHING, Reason


class Outcomes:
    """A task comes (ON or ASKING), goes (neither), answers a command, or is in trouble.

    All of these are remembered until the next command for the task, since a job may be done again, and be OFF, before
    another that came on with it has begun.
    """

    def __init__(self) -> None:
        self._troubles: dict[str, Reason] = {}
        self._answered: set[str] = set()
        self._came: set[str] = set()
        self._went: set[str] = set()

    # What a transaction wants

    def begin(self) -> None:
        """A transaction begins, or takes back what it did: no trouble of before counts."""
        self._troubles.clear()

    def expect_switch(self, off: Iterable[str], on: Iterable[str]) -> None:
        """These are told to go OFF, and those to come ON."""
        self._went.difference_update(off)
        self._came.difference_update(on)

    def expect_answer(self, task: str) -> None:
        """A task is to initialise itself, to be bound anew or to exchange its code."""
        self._answered.discard(task)
        self.excuse(task)

    def excuse(self, task: str) -> None:
        """A task's trouble does not count any more."""
        self._troubles.pop(task, None)

    # What happens

    def turn(self, task: str, state: State) -> None:
        """A task has come into another state."""
        (self._came if state in (State.ON, State.ASKING) else self._went).add(task)

    def answer(self, task: str) -> None:
        """A task has done what it was told."""
        self._answered.add(task)

    def fail(self, task: str, reason: Reason) -> None:
        """A task has failed, or refuses a command."""
        self._troubles[task] = reason

    def fail_all(self, reasons: Mapping[str, Reason]) -> None:
        """Several have, each for its reason."""
        self._troubles.update(reasons)

    # What is asked

    def has_come(self, task: str) -> bool:
        """Whether it has been ON, or asked, since it was told to come."""
        return task in self._came

    def has_gone(self, task: str) -> bool:
        """Whether it has been neither ON nor ASKING since it was told to go."""
        return task in self._went

    def has_answered(self, task: str) -> bool:
        """Whether it has done what it was told last."""
        return task in self._answered

    def has_trouble(self, task: str) -> bool:
        """Whether it has failed or refused something."""
        return task in self._troubles

    def found_no_gap(self, task: str) -> bool:
        """Whether its trouble is that it found no time between the cycles of its unit."""
        why = self._troubles.get(task, NOTHING).args.get("why")
        return isinstance(why, Reason) and why.key == "runtime.no_gap"

    def trouble(self, tasks: Iterable[str]) -> Reason:
        """What went wrong with these, as one sentence; empty if nothing did."""
        wrong = [task for task in dict.fromkeys(tasks) if task in self._troubles]
        reasons = [Reason.of("host.of_task", task=task, why=self._troubles[task]) for task in wrong]
        return Reason.of("host.several", reasons=tuple(reasons)) if len(reasons) > 1 else next(iter(reasons), NOTHING)
