"""Which worlds are simulated and which are real, as their code says without being opened (requirement E09)."""

from collections.abc import Iterable

from onika.host.loading.module_questions import ModuleQuestions
from onika.runtime.wiring import WiredTask
from onika.wire import live
from onika.words.fault import Fault
from onika.words.reason import Reason


def driven_kinds(tasks: Iterable[WiredTask], loading: ModuleQuestions) -> dict[str, bool]:
    """Whether each world that tasks have devices in is simulated; what cannot be used is told with its devices."""
    return _kinds({task.device.partition(":")[0] for task in tasks if task.device}, loading)[0]


def world_list(names: Iterable[str], loading: ModuleQuestions) -> live.WorldList:
    """The worlds of a runtime, and why others cannot be used."""
    return live.WorldList(*_kinds(names, loading))


def _kinds(names: Iterable[str], loading: ModuleQuestions) -> tuple[dict[str, bool], dict[str, Reason]]:
    answers = {name: loading.is_simulated(name) for name in sorted(names)}
    simulated = {name: answer for name, answer in answers.items() if not isinstance(answer, Fault)}
    return simulated, {name: answer.reason for name, answer in answers.items() if isinstance(answer, Fault)}
