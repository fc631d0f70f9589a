"""The engine once more, small, slow and obvious: it walks the trees of `kit.plans.program_tree` themselves.

Written from E04 to E08, E13, D10, D11 and readings 16 to 28 of the specification; it shares no code with the engine,
knows no orders and no late news. Where each flow is and which tasks are ON is all it tells.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field
from typing import Any

from kit.plans.program_tree import Act, Loop, Node, Pick, Side, Tree, acts

Halt = tuple[str, Any]
"""Where a walk stops: at a tag, at an action, at the flows it waits for before or behind a nested application."""


@dataclass
class ReferenceFlow:
    """A flow: what it is to do, where it is, who is ON."""

    tree: Tree
    parent: int | None
    state: str = "done"
    action: int = -1
    value: tuple[int, bool] | None = None
    """What the last action returned; none at the beginning and after a skip."""
    walk: Iterator[Halt] = field(default_factory=lambda: iter(()))
    at: Halt = ("end", None)
    is_pausing: bool = False
    leaving: set[str] = field(default_factory=set)
    loops: list[str] = field(default_factory=list)
    on: set[str] = field(default_factory=set)
    wanted: set[str] = field(default_factory=set)
    """Who was to be ON in the last action that was no no-op; all but its trigger hold on behind it (law 6)."""
    failed: set[str] = field(default_factory=set)
    interrupted: str = ""
    visits: dict[str, int] = field(default_factory=dict)

    def act(self) -> Act:
        """The present action, or the last one."""
        return acts(self.tree)[self.action]


class ReferenceEngine:
    """Told what happens, it goes on at once as far as it can; `told` is what began and what was done, in order."""

    def __init__(self, *trees: Tree, judge: Callable[[str], bool] = bool) -> None:
        self._judge = judge
        self.flows = [ReferenceFlow(tree, None) for tree in trees]
        self._children: dict[int, list[int]] = {}
        for number, tree in enumerate(trees):
            self._find_children(tree, number)
        self._parties: dict[str, list[int]] = {}
        for number, flow in enumerate(self.flows):
            for act in acts(flow.tree):
                if act.tag and number not in self._parties.setdefault(act.tag, []):
                    self._parties[act.tag].append(number)
        self.told: list[tuple[str, int, int]] = []

    @property
    def is_done(self) -> bool:
        """Whether all actions of all flows are done."""
        return all(flow.state == "done" for flow in self.flows)

    def waits_for(self, number: int) -> set[int]:
        """Whom a flow waits for."""
        flow = self.flows[number]
        if flow.state == "waiting":
            tag = flow.at[1]
            mine = flow.visits[tag]
            return {party for party in self._parties[tag] if self.flows[party].visits.get(tag, 0) < mine}
        if flow.state == "joining":
            return {other for other in flow.at[1] if self.flows[other].state != "done"}
        return set()

    # What happens

    def run(self) -> None:
        """All begin."""
        roots = [number for number, flow in enumerate(self.flows) if flow.parent is None]
        for number in roots:
            self._set_out(number)
        self._move()

    def finished(self, number: int, choice: int, loop: bool) -> None:
        """The trigger of the present action has finished."""
        flow = self.flows[number]
        self.told.append(("done", number, flow.action))
        flow.value = (choice, loop)
        flow.on -= set(flow.act().tasks[:1])
        flow.state = "paused" if self._rests(flow) else "going"
        flow.at = ("", None)
        self._move()

    def failed(self, number: int, task: str) -> None:
        """A task is in error: the flow stands still, its trigger goes off, who waits is not there any more."""
        flow = self.flows[number]
        if flow.state == "waiting":
            flow.visits[flow.at[1]] -= 1
        if flow.state != "stopped":
            flow.interrupted = flow.state
        if task in flow.on:
            flow.failed.add(task)
        flow.on.discard(task)
        if flow.interrupted == "running":
            flow.on -= set(flow.act().tasks[:1])
        flow.state = "stopped"

    def pause(self, number: int) -> None:
        """After the present action, or at once where the flow waits."""
        flow = self.flows[number]
        if flow.state in ("waiting", "joining"):
            if flow.state == "waiting":
                flow.visits[flow.at[1]] -= 1
            flow.state, flow.is_pausing = "paused", False
        else:
            flow.is_pausing = True

    def resume(self, number: int, steps: bool = False) -> None:
        """Go on; with `steps` for one action."""
        flow = self.flows[number]
        if flow.state == "paused":
            flow.state = "going"
        flow.is_pausing = steps
        self._move()

    def skip(self, number: int, action: int | None) -> None:
        """Out of the present action, to another one or on."""
        flow = self.flows[number]
        if flow.state == "waiting":
            flow.visits[flow.at[1]] -= 1
        if flow.state == "running":
            flow.on -= set(flow.act().tasks[:1])
        flow.value = None
        if action is not None:
            self._go_to(flow, action)
        elif flow.state == "running" or (flow.state == "stopped" and flow.interrupted == "running"):
            flow.at = ("", None)
        flow.failed.clear()
        flow.state = "going"
        self._move()

    def let_pass(self, number: int) -> None:
        """Wait no longer."""
        flow = self.flows[number]
        flow.state, flow.at = "going", ("", None)
        self._move()

    def leave(self, number: int) -> None:
        """The innermost loop that is not being left already is left at its next test."""
        flow = self.flows[number]
        flow.leaving.add([name for name in flow.loops if name not in flow.leaving][-1])

    def recover(self, number: int) -> None:
        """What failed is cleared; the step is repeated, or the flow is where it was."""
        flow = self.flows[number]
        if flow.interrupted == "running":
            flow.state, flow.failed = "going", set()
            flow.at = ("again", flow.action)
        else:
            flow.on |= flow.failed & flow.wanted
            flow.failed = set()
            rests = flow.interrupted == "paused" or flow.is_pausing
            flow.state = "paused" if rests else "going"
            flow.is_pausing = flow.is_pausing and not rests
        self._move()

    # Going on

    def _move(self) -> None:
        while True:
            number = next((place for place, flow in enumerate(self.flows) if self._can_go(place, flow)), None)
            if number is None:
                return
            self._go_on(number)

    def _can_go(self, number: int, flow: ReferenceFlow) -> bool:
        return flow.state == "going" or (flow.state in ("waiting", "joining") and not self.waits_for(number))

    def _go_on(self, number: int) -> None:
        flow = self.flows[number]
        if flow.state == "waiting":
            flow.at = ("", None)
        if flow.state == "joining" or (flow.state == "going" and flow.at[0] == "join"):
            if self._not_done(flow):
                flow.state = "joining"
                return
            flow.at = ("", None)
        flow.state = "going"
        if not flow.at[0]:
            flow.at = next(flow.walk, ("end", None))
        self._stop_at(number, flow)

    def _stop_at(self, number: int, flow: ReferenceFlow) -> None:
        kind, what = flow.at
        if kind == "tag":
            flow.visits[what] = flow.visits.get(what, 0) + 1
            flow.state = "waiting"
        elif kind == "join":
            flow.state = "joining"
        elif kind == "fork":
            for child in what:
                for tag in {act.tag for act in acts(self.flows[child].tree)}:
                    for small in self.flows:
                        small.visits.pop(tag, None)
                self._set_out(child)
            flow.at = ("", None)
        elif kind == "end":
            flow.state, flow.is_pausing = "done", False
        else:
            self._begin(number, flow, what)

    def _begin(self, number: int, flow: ReferenceFlow, action: int) -> None:
        flow.action = action
        self.told.append(("began", number, action))
        act = flow.act()
        if act.is_noop:
            self.told.append(("done", number, action))
            flow.value = (0, True)
            flow.at = ("", None)
            flow.state = "paused" if self._rests(flow) else "going"
            return
        flow.state, flow.on, flow.wanted = "running", set(act.tasks), set(act.tasks)

    def _rests(self, flow: ReferenceFlow) -> bool:
        condition = flow.act().breakpoint
        rests = flow.is_pausing or condition == "" or (condition is not None and self._judge(condition))
        flow.is_pausing = flow.is_pausing and not rests
        return rests

    def _not_done(self, flow: ReferenceFlow) -> bool:
        return any(self.flows[child].state != "done" for child in flow.at[1])

    def _set_out(self, number: int) -> None:
        flow = self.flows[number]
        flow.walk = self._walk(number, flow.tree, 0, [])
        flow.state, flow.value, flow.loops, flow.at = "going", None, [], ("", None)
        flow.leaving.clear()

    def _go_to(self, flow: ReferenceFlow, action: int) -> None:
        number = next(place for place, candidate in enumerate(self.flows) if candidate is flow)
        flow.loops = []
        flow.walk = self._walk(number, flow.tree, 0, [action])
        flow.at = next(flow.walk)
        flow.leaving &= set(flow.loops)

    # The walk through the tree

    def _walk(self, number: int, tree: Tree, first: int, goal: list[int]) -> Iterator[Halt]:
        """Through some nodes, of which the first action has the number `first`; with a goal straight to that action."""
        flow = self.flows[number]
        for node in tree:
            size = len(acts((node,)))
            if not goal or first <= goal[0] < first + size:
                match node:
                    case Act():
                        goal.clear()
                        if node.tag:
                            yield "tag", node.tag
                        yield "act", first
                    case Loop():
                        yield from self._around(number, node, first, goal)
                    case Pick():
                        yield from self._one_of(number, node, first, goal)
                    case Side():
                        children = self._children[id(node)]
                        if not goal:
                            yield "join", children
                            yield "fork", children
                        yield from self._walk(number, node.flows[0], first, goal)
                        yield "join", children
            first += size
        del flow

    def _around(self, number: int, loop: Loop, first: int, goal: list[int]) -> Iterator[Halt]:
        flow = self.flows[number]
        flow.loops.append(loop.name)
        test = loop.body[:1] if loop.is_top else loop.body
        rest = loop.body[1:] if loop.is_top else ()
        while True:
            if not goal or goal[0] < first + len(acts(test)):
                yield from self._walk(number, test, first, goal)
                goes_on = self._judge(loop.condition) if loop.condition else bool(flow.value and flow.value[1])
                if loop.name in flow.leaving or not goes_on:
                    break
            yield from self._walk(number, rest, first + len(acts(test)), goal)
            if rest and loop.name in flow.leaving:
                break
        flow.leaving.discard(loop.name)
        flow.loops.remove(loop.name)

    def _one_of(self, number: int, pick: Pick, first: int, goal: list[int]) -> Iterator[Halt]:
        starts = [first + sum(len(acts(branch)) for branch in pick.flows[:way]) for way in range(len(pick.flows))]
        if goal:
            way = max(way for way, start in enumerate(starts) if start <= goal[0] and acts(pick.flows[way]))
        elif pick.conditions:
            holding = [way for way, condition in enumerate(pick.conditions) if self._judge(condition)]
            way = holding[0] if holding else len(pick.flows) - 1
        else:
            value = self.flows[number].value
            way = value[0] if value and value[0] < len(pick.flows) else 0
        yield from self._walk(number, pick.flows[way], starts[way], goal)

    def _find_children(self, tree: tuple[Node, ...], number: int) -> None:
        """Flows of nested parallel applications are numbered as they are found."""
        for node in tree:
            match node:
                case Loop():
                    self._find_children(node.body, number)
                case Pick():
                    for flow in node.flows:
                        self._find_children(flow, number)
                case Side():
                    children = []
                    for flow in node.flows[1:]:
                        self.flows.append(ReferenceFlow(flow, number))
                        children.append(len(self.flows) - 1)
                        self._find_children(flow, children[-1])
                    self._children[id(node)] = children
                    self._find_children(node.flows[0], number)
