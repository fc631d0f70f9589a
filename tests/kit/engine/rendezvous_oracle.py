"""The oracle of simulated meetings: it knows what really happened, and says which promise was broken.

R1 nobody begins before all have come to the tag; R2 who begin together begin within twice the error of their clocks;
R3 who begins alone is held in time, and begins only when that was cleared; R4 nobody goes on behind a tag that another
has not begun; R5 when the faults are over, and users clear, everybody who has not crashed comes to his end. Whom a user
let pass counts as having been there.
"""

from collections import Counter
from collections.abc import Iterable

from onika.engine.rendezvous_terms import LATE_NS, RendezvousTerms
from onika.runtime.execution.appointments import SHARED_LATE_NS

Attempt = tuple[int, int]
"""A visit, and the number of an attempt."""


class RendezvousOracle:
    """Collects `faults`; all times are true ones in ns."""

    def __init__(self, sites: Iterable[int], terms: RendezvousTerms) -> None:
        self.faults: list[str] = []
        self.met = 0
        self.alone = 0
        self.longest_alone_ns = 0
        self.begins: dict[Attempt, dict[int, int]] = {}
        self._sites = frozenset(sites)
        self._terms = terms
        self._visits: Counter[int] = Counter()
        self._passed: set[tuple[int, int]] = set()
        self._begun: set[tuple[int, int]] = set()
        self._ends: dict[tuple[int, Attempt], int] = {}
        self._moving: dict[int, Attempt] = {}
        self._alone: set[int] = set()

    def comes(self, site: int, visit: int) -> None:
        """The flows of a runtime have come to the tag for this time."""
        self._visits[site] = visit

    def leaves(self, site: int) -> None:
        """They are gone from it before they began."""
        self._visits[site] -= 1

    def is_alone(self, site: int) -> None:
        """A runtime says that its flows have begun alone, and are held."""
        self._alone.add(site)

    def clears(self, site: int) -> None:
        """They may begin again: a user wants it, or they have moved nothing."""
        self._alone.discard(site)

    def passes(self, site: int, visit: int) -> None:
        """A user lets them pass, or all others have passed."""
        self._passed.add((site, visit))

    def crashes(self, site: int, now_ns: int) -> None:
        """The runtime is gone with its flows; its devices hold."""
        self.holds(site, now_ns)

    def begins_at(self, site: int, visit: int, attempt: int, now_ns: int) -> None:
        """They begin."""
        absent = [other for other in self._needed(visit) if self._visits[other] < visit]
        if absent:
            self.faults.append(f"R1: {site} begins visit {visit}, {absent} are not there")
        if site in self._alone:
            self.faults.append(f"R3: {site} begins visit {visit} and was not cleared")
        self.begins.setdefault((visit, attempt), {})[site] = now_ns
        self._begun.add((site, visit))
        self._moving[site] = (visit, attempt)

    def holds(self, site: int, now_ns: int) -> None:
        """What has begun is held."""
        attempt = self._moving.pop(site, None)
        if attempt is not None:
            self._ends[site, attempt] = now_ns

    def goes_on(self, site: int, visit: int) -> None:
        """The step behind the tag is over, and the next one begins."""
        absent = [other for other in self._needed(visit) if (other, visit) not in self._begun]
        if absent and (site, visit) not in self._passed:
            self.faults.append(f"R4: {site} goes on behind visit {visit}, {absent} have not begun")

    def final(self, now_ns: int, late: Iterable[int]) -> None:
        """The history is over; `late` have not come to their end although they could."""
        for attempt, times in self.begins.items():
            if self._needed(attempt[0]) <= set(times):
                self.met += 1
                self._judge_together(attempt, times)
            else:
                self.alone += 1
                self._judge_alone(attempt, times, now_ns)
        self.faults += [f"R5: {site} has not come to its end" for site in late]

    def _judge_together(self, attempt: Attempt, times: dict[int, int]) -> None:
        apart_ns = max(times.values()) - min(times.values())
        if apart_ns > 2 * self._terms.clock_ns + SHARED_LATE_NS:
            self.faults.append(f"R2: {attempt} begins {apart_ns} ns apart")

    def _judge_alone(self, attempt: Attempt, times: dict[int, int], now_ns: int) -> None:
        for site, began_ns in times.items():
            alone_ns = self._ends.get((site, attempt), now_ns) - began_ns
            self.longest_alone_ns = max(self.longest_alone_ns, alone_ns)
            if alone_ns > self._terms.alone_ns + 2 * LATE_NS:
                self.faults.append(f"R3: {site} is alone for {alone_ns} ns in {attempt}")

    def _needed(self, visit: int) -> frozenset[int]:
        return self._sites - {site for site, passed in self._passed if passed == visit}
