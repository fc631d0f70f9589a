"""The meetings of flows: where they wait for each other at the synchronisation tags of a plan (§5.5.4, reading 26).

The n-th visit of one flow meets the n-th of every other flow in whose program the tag stands. Who was let pass has been
there; who paused at the tag, or stopped there, has not come yet.
"""

from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence

from onika.engine.program import FlowProgram


class Meetings:
    """Counts who came where how often, and who waits."""

    def __init__(self, programs: Sequence[FlowProgram], shared: Collection[str] = ()) -> None:
        self.shared = frozenset(shared)
        """The tags at which flows of other runtimes are waited for, too."""
        parties: dict[str, list[int]] = {}
        for number, program in enumerate(programs):
            for tag in program.tags:
                parties.setdefault(tag, []).append(number)
        self._parties: Mapping[str, Sequence[int]] = parties
        self._visits = [Counter[str]() for _ in programs]
        self._waiting: dict[int, str] = {}

    def arrive(self, flow: int, tag: str) -> list[int]:
        """A flow comes to a tag; the flows that may go on with it, in their order; none while it has to wait."""
        self._visits[flow][tag] += 1
        self._waiting[flow] = tag
        return [] if tag in self.shared else self.release(tag)

    def come_back(self, flow: int, tag: str) -> None:
        """A flow that has begun alone waits at the tag once more, for the same visit."""
        self._waiting[flow] = tag

    def gathered(self, tag: str) -> list[int]:
        """The flows that wait at a tag and for no other flow of this runtime, in their order."""
        return sorted(flow for flow, where in self._waiting.items() if where == tag and not self.absent(flow))

    def release(self, tag: str) -> list[int]:
        """Those go on."""
        together = self.gathered(tag)
        for other in together:
            del self._waiting[other]
        return together

    def let_pass(self, flow: int) -> None:
        """A flow does not wait any longer; it has been there."""
        del self._waiting[flow]

    def withdraw(self, flow: int) -> None:
        """A flow does not wait here at present; it comes again, or goes elsewhere."""
        tag = self._waiting.pop(flow)
        self._visits[flow][tag] -= 1

    def absent(self, flow: int) -> list[int]:
        """The flows that a waiting flow waits for."""
        tag = self._waiting[flow]
        visit = self._visits[flow][tag]
        return [other for other in self._parties[tag] if self._visits[other][tag] < visit]

    def waits_at(self, flow: int) -> str:
        """The tag at which a flow waits; empty: at none."""
        return self._waiting.get(flow, "")

    def begin_anew(self, tags: Iterable[str]) -> None:
        """The nested application in which these tags stand is run once more."""
        for tag in tags:
            for visits in self._visits:
                visits.pop(tag, None)
