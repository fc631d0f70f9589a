"""Loops that go round without taking any time: nothing in them would ever let go of the flow (requirement E05).

Only jobs take time; no-ops, empty flows and choices do not. What counts is the fastest way round.
"""

from collections.abc import Iterator, Mapping

from onika.model.application import Action, Branch
from onika.model.rules.loop import Loop, loops
from onika.model.rules.nesting import Nest
from onika.model.rules.outline import Outline, Passage
from onika.model.syntax import Syntax
from onika.words.fault import Fault
from onika.words.reason import Reason


def faults(nest: Nest, syntax: Syntax) -> Iterator[Fault]:
    """The loops of all applications of a nest round which there is a way without a job."""
    endless: dict[str, bool] = {}
    for name, outline in nest.outlines.items():
        flows: dict[str, bool] = {}
        faults: list[Fault] = []
        for passage in reversed(outline.passages):  # the flows of a branch stand behind the one it stands in
            takes, slack = _passage(outline, passage, nest, syntax, endless, flows)
            flows[passage.path] = takes
            faults += [_fault(outline, passage, loop) for loop in slack]
        outer = [flows[passage.path] for passage in outline.passages if not passage.is_inner]
        endless[name] = any(outer) if outline.application.is_parallel else all(outer)
        yield from reversed(faults)


def _passage(
    outline: Outline,
    passage: Passage,
    nest: Nest,
    syntax: Syntax,
    endless: Mapping[str, bool],
    flows: Mapping[str, bool],
) -> tuple[bool, list[Loop]]:
    """Whether every way through a flow takes time, and its loops round which one takes none."""
    by_position = {action.position: action for action in passage.actions}
    endings = loops(passage.flow, passage.actions)
    starts = {loop.start: loop for loop in endings}
    ends = {loop.end: loop for loop in endings}
    slack: list[Loop] = []
    takes = [False]  # of the flow and every loop that is open: whether what was met in it so far takes time
    for position, step in enumerate(passage.flow.steps):
        if position in starts:
            takes.append(False)
        if isinstance(step, Branch):
            takes[-1] |= _branch_takes(passage, position, step, flows)
        elif action := by_position.get(position):
            takes[-1] |= _takes(outline, action, nest, syntax, endless)
        if loop := ends.get(position):
            round_it = takes.pop()
            slack += [] if round_it else [loop]
            test = by_position.get(loop.test)
            if test and loop.is_top and _may_leave(test, syntax):
                takes[-1] |= _takes(outline, test, nest, syntax, endless)  # the rest of the loop may be passed by
            else:
                takes[-1] |= round_it
    return takes[0], slack


def _may_leave(test: Action, syntax: Syntax) -> bool:
    """Whether the test of a loop can end it: a no-op only by a condition."""
    return not _is_noop(test, syntax) or bool(test.icon.while_if)


def _branch_takes(passage: Passage, position: int, branch: Branch, flows: Mapping[str, bool]) -> bool:
    """Whether every way through a branch takes time."""
    inner = [flows[f"{passage.path}, step {position}, branch {at}"] for at in range(len(branch.flows))]
    return bool(inner) and all(inner)


def _takes(outline: Outline, action: Action, nest: Nest, syntax: Syntax, endless: Mapping[str, bool]) -> bool:
    inner = nest.runs(outline, action, syntax)
    if inner:
        return endless[inner.application.name]
    return not _is_noop(action, syntax)


def _is_noop(action: Action, syntax: Syntax) -> bool:
    kind = syntax.acting(action.icon.onikon.type)
    return kind is not None and kind.is_noop


def _fault(outline: Outline, passage: Passage, loop: Loop) -> Fault:
    steps = passage.flow.steps
    start, end = outline.at(passage, loop.start), outline.at(passage, loop.end)
    return outline.fault(steps[loop.start], Reason.of("rules.loop_without_job", tag=loop.tag, start=start, end=end))
