"""Where flows wait for each other: the synchronisation tags of a plan (§5.5.4, decision 26)."""

from collections.abc import Iterable, Mapping, Sequence

from onika.engine.flow import FlowState
from onika.engine.progress import Progress
from onika.wire.plan import PlannedFlow


class Meetings:
    """Which flows meet at which tag; the n-th visit of one flow pairs with the n-th of every other."""

    def __init__(self, flows: Sequence[PlannedFlow]) -> None:
        parties: dict[str, list[int]] = {}
        for number, flow in enumerate(flows):
            for tag in dict.fromkeys(action.synch_tag for action in flow.actions if action.synch_tag is not None):
                parties.setdefault(tag, []).append(number)
        self._parties: Mapping[str, Sequence[int]] = parties

    def parties(self, tag: str) -> Sequence[int]:
        """The flows that meet at this tag, in their order."""
        return self._parties[tag]

    def absent(self, tag: str, flows: Sequence[Progress]) -> list[int]:
        """The flows that have not yet come to this tag; empty: all may go on."""
        return [number for number in self._parties[tag] if _waits_at(flows[number]) != tag]

    def deserted(self, ended: int, flows: Iterable[Progress]) -> list[tuple[Progress, str]]:
        """The flows that wait for one that has no more actions, each with its tag."""
        waiting = [(flow, tag) for flow in flows if (tag := _waits_at(flow)) is not None]
        return [(flow, tag) for flow, tag in waiting if ended in self._parties[tag]]


def _waits_at(flow: Progress) -> str | None:
    following = flow.next_step
    return following.synch_tag if flow.state is FlowState.WAITING and following is not None else None
