"""The flows of the application file: FLOW … ENDFLOW, and BRANCH … ENDBRANCH within them (dissertation §A.4).

Branches are of version 2.0: in a flow may stand `BRANCH`, flows of its own, and `ENDBRANCH`, to any depth. With a
condition behind FLOW of each but the last, the first that holds chooses its flow; with none, a returned value does.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from onika.files.line import FileLine, row
from onika.files.routine import is_extended, marked, read_condition, read_routine, write_routine
from onika.files.text_reading import KeywordSlot, Need, TextReading
from onika.model.application import AppFlow, Branch, Hole, Icon, Step, actions, flows_within
from onika.model.syntax import Syntax
from onika.words.reason import Reason

HEADS = frozenset({"FLOW", "ICONHOLE", "ENDFLOW", "BRANCH", "ENDBRANCH", "ROUTINE"})
"""The keywords that begin a block of lines."""

DEEPEST = 100
"""How many branches may stand within each other."""


def read_flows(blocks: Sequence[Sequence[FileLine]], syntax: Syntax, reading: TextReading) -> tuple[AppFlow, ...]:
    """The flows of the blocks of an application, which begin with the words of `HEADS`."""
    nest = _Nest(syntax, reading)
    for block in blocks:
        if reading.is_full:
            break
        nest.take(block)
    if blocks:
        nest.end(blocks[-1][-1].number)
    return tuple(nest.flows)


def write_flow(flow: AppFlow, condition: str = "") -> str:
    """The lines of a flow with all its branches."""
    return "\n".join([row("FLOW", condition), *map(_show, flow.steps), row("ENDFLOW")])


def has_extensions(flow: AppFlow) -> bool:
    """Whether its lines are of version 2.0."""
    steps = [step for _, inner in flows_within(flow, "") for step in inner.steps]
    return any(isinstance(step, Branch) or is_extended(step) for step in steps)


def depth(flows: Sequence[AppFlow]) -> int:
    """How many branches stand within each other."""
    deepest = -1
    while flows:
        flows = [
            branch_flow
            for flow in flows
            for step in flow.steps
            if isinstance(step, Branch)
            for branch_flow in step.flows
        ]
        deepest += 1
    return max(deepest, 0)


def _show(step: Step) -> str:
    if isinstance(step, Icon):
        return write_routine(step)
    if isinstance(step, Hole):
        return step.kept or row("ICONHOLE")
    conditions = (*step.conditions, *[""] * (len(step.flows) - len(step.conditions)))
    inner = (write_flow(flow, condition) for flow, condition in zip(step.flows, conditions, strict=True))
    return "\n".join([row("BRANCH"), *inner, row("ENDBRANCH")])


@dataclass(slots=True)
class _OpenFlow:
    """A flow that has not ended."""

    head: FileLine
    steps: list[Step] = field(default_factory=list)


@dataclass(slots=True)
class _OpenBranch:
    """A branch that has not ended, with the lines of the flows that have."""

    head: FileLine
    heads: list[FileLine] = field(default_factory=list)
    flows: list[AppFlow] = field(default_factory=list)


class _Nest:
    """What is open at a line, outermost first, and the flows that are closed."""

    def __init__(self, syntax: Syntax, reading: TextReading) -> None:
        self.flows: list[AppFlow] = []
        self._syntax = syntax
        self._reading = reading
        self._open: list[_OpenFlow | _OpenBranch] = []

    def take(self, block: Sequence[FileLine]) -> None:
        """One block: the words alone on their lines, or an icon."""
        first = block[0]
        match first.keyword:
            case "FLOW":
                self._begin_flow(first)
                self._alone(block, is_bare=len(self._open) == 1)
            case "ENDFLOW":
                self._alone(block)
                self._end_flow(first)
            case "BRANCH":
                self._alone(block, Need.OF_2_0)
                self._begin_branch(first)
            case "ENDBRANCH":
                self._alone(block, Need.OF_2_0)
                self._end_branch(first)
            case "ICONHOLE":
                self._alone(block)
                self._flow(first).steps.append(Hole(first.number))
            case _:
                flow = self._flow(first)
                step = read_routine(block, self._syntax, self._reading)
                flow.steps += [step] if step else []

    def end(self, number: int) -> None:
        """The end of the application, in line `number`; nothing may be open."""
        if self._open and not self._reading.is_full:
            missing = "ENDFLOW" if isinstance(self._open[-1], _OpenFlow) else "ENDBRANCH"
            self._reading.fault(number, Reason.of("files.flow_unclosed", missing=missing))
        while self._open:
            self._close()

    def _alone(self, block: Sequence[FileLine], need: Need = Need.ALWAYS, *, is_bare: bool = True) -> None:
        if len(block) > 1 or need is not Need.ALWAYS:
            self._reading.arrange(block, (KeywordSlot(block[0].keyword, need),))
        if is_bare:
            self._reading.bare(block[0])

    def _flow(self, line: FileLine) -> _OpenFlow:
        """The flow in which a line stands; a fault where there is none, and then one is taken to begin there."""
        top = self._open[-1] if self._open else None
        if isinstance(top, _OpenFlow):
            return top
        self._reading.fault(line.number, Reason.of("files.flow_expected", line=str(line)))
        flow = _OpenFlow(FileLine(line.number, "FLOW", ""))
        self._open.append(flow)
        return flow

    def _begin_flow(self, line: FileLine) -> None:
        if self._open and isinstance(self._open[-1], _OpenFlow):
            self._reading.fault(line.number, Reason.of("files.endflow_before_next_flow", line=str(line)))
            self._close()
        self._open.append(_OpenFlow(line))

    def _end_flow(self, line: FileLine) -> None:
        if not self._open:
            self._reading.fault(line.number, Reason.of("files.flow_expected", line=str(line)))
            return
        if isinstance(self._open[-1], _OpenBranch):
            self._reading.fault(line.number, Reason.of("files.flow_or_endbranch", line=str(line)))
            self._close()
        self._close()

    def _begin_branch(self, line: FileLine) -> None:
        self._flow(line)
        self._open.append(_OpenBranch(line))
        if sum(isinstance(opening, _OpenBranch) for opening in self._open) > DEEPEST:
            self._reading.fault(line.number, Reason.of("files.branches_too_deep", deepest=DEEPEST))
            self._reading.is_full = True

    def _end_branch(self, line: FileLine) -> None:
        if not any(isinstance(opening, _OpenBranch) for opening in self._open):
            self._reading.fault(line.number, Reason.of("files.branch_before_endbranch", line=str(line)))
            return
        if isinstance(self._open[-1], _OpenFlow):
            self._reading.fault(line.number, Reason.of("files.endflow_before_endbranch", line=str(line)))
            self._close()
        branch = self._open[-1]
        if isinstance(branch, _OpenBranch) and not branch.flows:
            self._reading.fault(line.number, Reason.of("files.branch_empty"))
        self._close()

    def _close(self) -> None:
        """Put what was opened last where it belongs."""
        top = self._open.pop()
        outer = self._open[-1] if self._open else None
        if isinstance(top, _OpenFlow):
            flow = _settled(top.steps, self._syntax, self._reading)
            if isinstance(outer, _OpenBranch):
                outer.heads.append(top.head)
                outer.flows.append(flow)
            else:
                self.flows.append(flow)
        elif isinstance(outer, _OpenFlow):
            outer.steps.append(Branch(tuple(top.flows), tuple(self._conditions(top)), top.head.number))

    def _conditions(self, branch: _OpenBranch) -> Iterator[str]:
        """The conditions of a branch: behind each FLOW but the last, or behind none."""
        conditional = [head for head in branch.heads if head.rest]
        if not conditional:
            return
        for at, head in enumerate(branch.heads):
            if bool(head.rest) != (at < len(branch.heads) - 1):
                self._reading.fault(head.number, Reason.of("files.branch_conditions", head=str(head)))
            elif head.rest:
                yield read_condition(head, self._reading)


def _settled(steps: list[Step], syntax: Syntax, reading: TextReading) -> AppFlow:
    """A flow with the marks of its targets on their jobs (reading 24) and one hole for several (reading 33)."""
    for action in actions(AppFlow(tuple(steps)), syntax):
        for at in range(action.position + 1, action.end):
            job, target = steps[action.position], steps[at]
            if isinstance(job, Icon) and isinstance(target, Icon):
                steps[action.position], steps[at] = marked(job, target, reading)
    kept = [step for at, step in enumerate(steps) if not (step == Hole() and at and steps[at - 1] == step)]
    return AppFlow(tuple(kept))
