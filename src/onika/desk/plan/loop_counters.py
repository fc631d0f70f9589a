"""Jobs that only count how often a loop is gone through: where they decide no loop, nothing is repeated (E01)."""

import ast
from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path

from onika.desk.plan.declarations import declared_ports
from onika.files import text
from onika.model.application import Action, Icon
from onika.model.configuration import Configuration
from onika.model.rules.outline import Outline, Passage
from onika.model.syntax import Syntax
from onika.store.program import ApplicationProgram
from onika.words.fault import Fault
from onika.words.reason import Reason


def faults(program: ApplicationProgram, syntax: Syntax, file: str) -> Iterator[Fault]:
    """The jobs of an application that would count a loop and are the test of none.

    Applications that it runs as icons are not looked into: what their last action returns may decide a loop here.
    """
    outline = Outline.of(program.application, syntax, file)
    for passage, action in outline.actions():
        configuration = program.configurations.get(action.icon.onikon.name)
        if configuration and _only_counts(configuration, program) and not _decides(passage, action):
            at = outline.at(passage, action.position)
            yield outline.fault(action.icon, Reason.of("desk.repeats_nothing", name=action.icon.onikon.name, at=at))


def counts_loops(code: Path) -> bool:
    """Whether all that a module does is to return whether a loop is gone through again: it has no ports."""
    try:
        status = code.stat()
    except OSError:
        return False
    return not declared_ports(code) and _returns_loop(code, status.st_mtime_ns, status.st_size)


def _only_counts(configuration: Configuration, program: ApplicationProgram) -> bool:
    tasks: Mapping[str, Path | None] = {
        placed.task: program.code.get(program.tasks[placed.task].module)
        for placed in configuration.placed
        if placed.task in program.tasks
    }
    return bool(tasks) and all(code is not None and counts_loops(code) for code in tasks.values())


def _decides(passage: Passage, action: Action) -> bool:
    """Whether an action is the test of a loop; a mark on its target is one of it (reading 24)."""
    steps = passage.flow.steps[action.position : action.end]
    return any(isinstance(step, Icon) and step.while_tag is not None and step.while_test for step in steps)


@lru_cache(maxsize=1024)  # applications are judged after every change
def _returns_loop(code: Path, _written_ns: int, _size: int) -> bool:
    source, _ = text.load(code, str(code))
    try:
        tree = ast.parse(source or "")
    except (SyntaxError, ValueError, RecursionError):
        return False  # a runtime says what is wrong with it
    calls = (node for node in ast.walk(tree) if isinstance(node, ast.Call))
    ends = [call for call in calls if isinstance(call.func, ast.Name) and call.func.id == "finish"]
    loops = [keyword.value for call in ends for keyword in call.keywords if keyword.arg == "loop"]
    return bool(loops) and len(loops) == len(ends) and not any(isinstance(value, ast.Constant) for value in loops)
