"""Jobs that only count how often a loop is gone through: where they decide no loop, nothing is repeated (E01).

Each number counts apart, so loops within each other need different numbers.
"""

import ast
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from itertools import permutations
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
    """The jobs of an application that would count a loop and are the test of none, or count two loops as one.

    Applications that it runs as icons are not looked into: what their last action returns may decide a loop here.
    """
    outline = Outline.of(program.application, syntax, file)
    loops: list[_CountedLoop] = []
    for passage, action in outline.actions():
        configuration = program.configurations.get(action.icon.onikon.name)
        if not configuration or not _only_counts(configuration, program):
            continue
        if _decides(passage, action):
            loops.append(_CountedLoop.of(passage, action))
        else:
            at = outline.at(passage, action.position)
            yield outline.fault(action.icon, Reason.of("desk.repeats_nothing", name=action.icon.onikon.name, at=at))
    for outer, inner in permutations(loops, 2):
        if outer.counts_with(inner):
            at, other = (outline.at(loop.passage, loop.action.position) for loop in (inner, outer))
            yield outline.fault(inner.action.icon, Reason.of("desk.counts_alike", at=at, other=other))


@dataclass(frozen=True, slots=True)
class _CountedLoop:
    """A loop that a job counts, from its first step to its last."""

    passage: Passage
    action: Action
    first: int
    last: int

    @classmethod
    def of(cls, passage: Passage, action: Action) -> "_CountedLoop":
        """The loop that an action decides."""
        steps = passage.flow.steps
        tags = {step.while_tag for step in _tests(passage, action)}
        ends = [at for at, step in enumerate(steps) if isinstance(step, Icon) and step.while_tag in tags]
        return cls(passage, action, min(ends), max(*ends, action.end - 1))

    @property
    def number(self) -> tuple[object, ...]:
        """How often, as its targets say."""
        steps = self.passage.flow.steps[self.action.position + 1 : self.action.end]
        return tuple(step.onikon.values for step in steps if isinstance(step, Icon))

    def counts_with(self, inner: "_CountedLoop") -> bool:
        """Whether another loop lies within it, and one counter could not tell them apart."""
        is_alike = (self.action.icon.onikon.name, self.number) == (inner.action.icon.onikon.name, inner.number)
        return is_alike and self._surrounds(inner)

    def _surrounds(self, inner: "_CountedLoop") -> bool:
        """In the same flow, or in one of a branch that stands within it."""
        if inner.passage is self.passage:
            return self.first <= inner.first and inner.last < self.action.position
        branches = (f"{self.passage.path}, step {at}," for at in range(self.first, self.action.position))
        return any(inner.passage.path.startswith(branch) for branch in branches)


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
    return any(True for _ in _tests(passage, action))


def _tests(passage: Passage, action: Action) -> Iterator[Icon]:
    """Its steps that are the test of a loop."""
    for step in passage.flow.steps[action.position : action.end]:
        if isinstance(step, Icon) and step.while_tag is not None and step.while_test:
            yield step


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
