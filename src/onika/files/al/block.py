"""A block of AL that is being read: its flow so far, its parts before, and marks that wait for an action."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

from onika.files.al.logical_line import Statement
from onika.model.application import AppFlow, Branch, Hole, Icon, Step
from onika.words.reason import NOTHING, Reason

ENDS = {
    "BEGIN": "END",
    "COBEGIN": "COEND",
    "CASE OF": "END CASE",
    "IF": "END IF",
    "WHILE": "END WHILE",
    "REPEAT": "UNTIL",
}
"""By what each kind of block ends."""


@dataclass(frozen=True, slots=True)
class LoopMark:
    """A TAG, one end of a loop that is no block."""

    sentence: Statement
    tag: str
    is_test: bool
    condition: str


@dataclass(slots=True)
class Block:
    """One block: `kind` is the word it begins with, `items` the statements of the part that is being read."""

    kind: str
    opened: Statement
    is_implied: bool = False
    """Whether its BEGIN is lacking, which is told already."""
    depth: int = 0
    """How many branches it stands in, or is."""
    tag: str = ""
    """Of a loop."""
    items: list[list[Step]] = field(default_factory=list)
    flows: list[AppFlow] = field(default_factory=list)
    conditions: list[str] = field(default_factory=list)
    is_last: bool = False
    """Whether its ELSE or DO was read."""
    tests: list[list[Step]] = field(default_factory=list)
    """Of a WHILE that came to its DO: the statements before that."""
    condition: str = ""
    """Of a WHILE: the one its DO says."""
    synch: tuple[Statement, str] | None = None
    """A SYNCH that waits for its action."""
    loop_mark: LoopMark | None = None
    """A TAG that waits for its action."""
    takes_break: bool = False
    """Whether the sentence before was an action, which may be followed by BREAK."""

    @property
    def holds_flows(self) -> bool:
        """Whether only BEGIN … END stands in it."""
        return self.kind in ("COBEGIN", "CASE OF")

    def add(self, steps: Sequence[Icon | Hole]) -> None:
        """A statement, whose first icon bears what waited."""
        first = steps[0]
        if isinstance(first, Icon):
            if self.synch:
                first = replace(first, synch_tag=self.synch[1])
            if mark := self.loop_mark:
                first = replace(first, while_tag=mark.tag, while_test=mark.is_test, while_if=mark.condition)
            self.synch = self.loop_mark = None
        self.items.append([first, *steps[1:]])
        self.takes_break = isinstance(first, Icon)

    def lose(self) -> None:
        """A statement that is wrong, which is told: nothing stands for it, and its marks are gone."""
        self.synch = self.loop_mark = None
        self.items.append([])
        self.takes_break = True

    def rest(self, condition: str, *, is_off: bool) -> None:
        """A breakpoint after the last statement; one that is off only keeps its condition."""
        first = next(iter(self.items[-1]), None)
        if isinstance(first, Icon):
            self.items[-1][0] = replace(first, marker=not is_off, marker_if=condition)
        self.takes_break = False

    def end_part(self) -> None:
        """The part that was read is a flow; the next one begins."""
        self.flows.append(self.flow())
        self.items = []

    def flow(self) -> AppFlow:
        """The part that was read, holes side by side as one."""
        steps = [step for item in self.items for step in item]
        kept = [step for at, step in enumerate(steps) if not (isinstance(step, Hole) and at and steps[at - 1] == step)]
        return AppFlow(tuple(kept))

    def branch(self) -> Branch:
        """What a CASE OF or IF is in its flow."""
        return Branch(tuple(self.flows), tuple(self.conditions), self.opened.number)


def marked(items: list[list[Step]], at: int, tag: str, *, is_test: bool, condition: str = "") -> Reason:
    """Put a loop's tag on the statement `at`; gives what stands there in place of an action that may bear it, if so."""
    if not items:
        return Reason.of("files.nothing")
    if not items[at]:
        return NOTHING  # what stood there is wrong, and told
    step = items[at][0]
    if not isinstance(step, Icon):
        return Reason.of("files.a_hole") if isinstance(step, Hole) else Reason.of("files.a_branch")
    if step.while_tag is not None:
        return Reason.of("files.bears_tag", name=step.onikon.name, tag=step.while_tag)
    items[at][0] = replace(step, while_tag=tag, while_test=is_test, while_if=condition)
    return NOTHING
