"""The flow tracker: follows events to know the state of each flow, and which wait conditions came (requirement E11)."""

from collections.abc import Iterable

from onika.desk.plan.flow_index import FlowIndex
from onika.desk.run.flow_status import FlowStatus
from onika.desk.run.wait_condition import WaitCondition
from onika.wire import event, steer
from onika.words.reason import Reason

OVER = ("done", "killing", "ended")
"""States in which a flow has nothing more to do."""

STILL = ("paused", "stopped", "waiting", "joining")
"""States that a flow leaves only because of another flow, or of somebody who steers."""


class FlowTracker:
    """Hears events and answers whether a condition has come.

    What a wait was over for is forgotten, with all of that flow before it: the next wait looks at what came later.
    """

    def __init__(self, flow_index: FlowIndex) -> None:
        self.statuses = {name: FlowStatus() for name in flow_index.subsystems}
        self._past: dict[str, list[tuple[str, int | None]]] = {name: [] for name in flow_index.subsystems}
        """What happened, oldest first, since a wait was over for a flow: a kind of condition, and the action."""
        self._names = flow_index.subsystems
        self.is_asking = False
        self.done = 0

    def hear(self, message: event.Event) -> None:
        """Take in what has happened."""
        match message:
            case event.Began():
                name = self._names[message.flow]
                self.statuses[name] = self.statuses[name].began(message)
                self._past[name].append(("began", message.index))
            case event.Done():
                name = self._names[message.flow]
                self.done += 1
                self.statuses[name] = self.statuses[name].done()
                self._past[name].append(("done", message.index))
            case event.Moved() if message.subsystem in self.statuses:
                self._moved(message)
            case event.Asked():
                self.is_asking = True
            case event.TaskState() if message.state != "ASKING":
                self.is_asking = False

    def _moved(self, moved: event.Moved) -> None:
        former = self.statuses[moved.subsystem]
        is_new = (moved.state, moved.action, moved.tag) != (former.state, former.action, former.tag) or not moved.text
        self.statuses[moved.subsystem] = former.moved(moved)
        if is_new:  # else only something about it is told
            self._past[moved.subsystem].append((moved.state, None))

    def place(self, positions: Iterable[steer.Position]) -> None:
        """What the runtime says of itself now counts more than what was heard."""
        for position in positions:
            if position.subsystem in self.statuses:
                self.statuses[position.subsystem] = self.statuses[position.subsystem].placed(position)

    def steered(self, subsystem: str, *, is_skip: bool = False) -> None:
        """A flow, or all, is being steered: what it was in is past; after a skip so is what it did."""
        for name, past in self._past.items():
            if subsystem in ("", name):
                self._past[name] = [] if is_skip else [step for step in past if step[1] is not None]

    def has_come(self, condition: WaitCondition) -> bool:
        """Whether a condition other than a time has come; if so it is past now."""
        names = [condition.subsystem] if condition.subsystem else list(self.statuses)
        came = [name for name in names if (condition.kind, condition.action) in self._past[name]]
        if condition.kind in ("paused", "done") and condition.action is None:
            over = [name for name in names if name not in came and self.statuses[name].state in OVER]
            is_so = len(came) + len(over) == len(names) and (bool(came) or condition.kind == "done")
        else:
            is_so = bool(came)
        if is_so:
            for name in came:
                past = self._past[name]
                del past[: past.index((condition.kind, condition.action)) + 1]
        return is_so

    @property
    def is_stuck(self) -> bool:
        """Whether no flow goes on by itself, and not all are done; who waits for other runtimes goes on with them."""
        spots = self.statuses.values()
        if any(spot.state == "waiting" and not spot.waits_for for spot in spots):
            return False
        states = [spot.state for spot in spots]
        return all(state in (*STILL, *OVER) for state in states) and any(state in STILL for state in states)

    def standing(self) -> Reason:
        """Who stands still and why, in words."""
        still = [(name, spot) for name, spot in self.statuses.items() if spot.state in STILL]
        return Reason.of("desk.flows_stand", flows=tuple(_words(name, spot) for name, spot in still))


def _words(flow: str, spot: FlowStatus) -> Reason:
    match spot.state:
        case "waiting" if spot.waits_for:
            return Reason.of("desk.flow_waits_at_for", flow=flow, tag=spot.tag, flows=spot.waits_for)
        case "waiting":
            return Reason.of("desk.flow_waits_at", flow=flow, tag=spot.tag)
        case "joining" if spot.waits_for:
            return Reason.of("desk.flow_waits_for", flow=flow, flows=spot.waits_for)
        case "joining":
            return Reason.of("desk.flow_waits_nested", flow=flow)
        case "stopped":
            return Reason.of("desk.flow_stopped_in", flow=flow, number=spot.action + 1)
        case _ if spot.action >= 0:
            return Reason.of("desk.flow_paused_after", flow=flow, number=spot.action + 1)
        case _:
            return Reason.of("desk.flow_paused_before", flow=flow)
