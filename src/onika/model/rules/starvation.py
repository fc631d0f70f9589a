"""Starvation: the hardware to which, from task to task, a value comes that a task wrote which has failed (law 4)."""

from collections.abc import Collection, Iterable

from onika.model.lifecycle import State
from onika.model.rules.order import Ports
from onika.words.reason import Reason


def starved(failed: Ports, working: Iterable[Ports], hardware: Collection[str]) -> dict[str, str]:
    """The hardware tasks among the `working` ones that are fed by the failed one, each with the variable it wrote.

    What a hardware task publishes is measured anew in each cycle: nothing comes through it.
    """
    tasks = [task for task in working if task.name != failed.name]
    origins = {variable: variable for variable in failed.outvar}
    fed: dict[str, str] = {}
    for _ in tasks:  # each time at least one more task is reached, if any
        for task in tasks:
            stale = next((origins[variable] for variable in task.invar if variable in origins), None)
            if stale is None:
                continue
            if task.name in hardware:
                fed.setdefault(task.name, stale)
            else:
                for variable in task.outvar:
                    origins.setdefault(variable, stale)
    return fed


def writer_failed(task: str, variable: str, state: State) -> Reason:
    """Why a device is not driven on."""
    return Reason.of("rules.writer_failed", task=task, variable=variable, state=state.value)
