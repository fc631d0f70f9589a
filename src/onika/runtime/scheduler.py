"""The scheduler of one RTPU: a release queue and a ready queue, earliest deadline first; sans-I/O (laws 1, 2).

A task in the scheduler is a mutable `TaskSlot`. Released slots wait by (deadline, criticality, rank, name), which fixes
the order at one instant whatever came before. A slot whose deadline has passed before it could run is late: the periods
it is late by are counted and skipped, and it runs once for the period that is open.

Slots of one period that are due together may be *grouped*: then they are due as one. Whatever else becomes of a slot
parts all groups again.
"""

from collections.abc import Iterable, Sequence
from heapq import heapify, heappop, heappush, heapreplace


class TaskSlot:
    """A task's place on the scheduler. `key` sorts tasks with the same deadline: (-criticality, rank, name)."""

    __slots__ = ("deadline", "epoch", "is_listed", "key", "missed", "period", "release")

    def __init__(self, key: tuple[int, int, str], period_ns: int) -> None:
        self.key = key
        self.period = period_ns
        self.release = 0
        self.deadline = 0
        self.missed = 0
        self.epoch = 0
        self.is_listed = False

    def skip(self, now: int) -> None:
        """Move on to the period that is open at `now`, counting the whole periods it is late by."""
        self.missed += (now - self.release) // self.period
        self.release = now - now % self.period
        self.deadline = self.release + self.period


_Release = tuple[int, int, int, int, str, int, TaskSlot]


class SlotGroup:
    """All slots of one period, in their order: due together, again and again."""

    __slots__ = ("period", "slots")

    def __init__(self, slots: Iterable[TaskSlot]) -> None:
        self.slots = tuple(slots)
        self.period = self.slots[0].period


class Scheduler:
    """Slots by release time, then by deadline; time is handed in as integer nanoseconds."""

    def __init__(self) -> None:
        self.groups: list[tuple[int, int, SlotGroup]] = []
        """Release, deadline and slots of each group, as a heap in this one list; with any, nothing else is due."""
        self._releases: list[_Release] = []
        self._ready: list[tuple[int, int, int, str, int, TaskSlot]] = []
        self._epoch = 0
        self._coming: dict[TaskSlot, int] = {}

    def enter(self, slot: TaskSlot, now: int) -> None:
        """Due at once, then on the common grid of multiples of the period.

        What enters waits outside until `next_due` is asked, and then enters with the time of that: tasks that come on
        together enter together, and what the `on` of one took makes no other one late.
        """
        if self.groups:
            self.part()
        slot.epoch = self._epoch = self._epoch + 1  # as `leave`, without a call: a switch enters many
        slot.is_listed = False
        self._coming[slot] = now

    def resume(self, slot: TaskSlot, now: int) -> None:
        """Due at the next point of the common grid, and no sooner."""
        if self.groups:
            self.part()
        self._coming.pop(slot, None)
        self._renew(slot)
        slot.is_listed = True
        release = _next_on_grid(now, slot.period)
        self._list(slot, release, release + slot.period)

    def leave(self, slot: TaskSlot) -> None:
        """Not due any more; what still lies in the queues is stale by its epoch."""
        if self.groups:
            self.part()
        self._renew(slot)
        slot.is_listed = False
        self._coming.pop(slot, None)

    def change(self, slot: TaskSlot, period_ns: int, now: int) -> None:
        """Another period from now on; a release that is due already stays due, later ones lie on the new grid."""
        if self.groups:
            self.part()
        slot.period = period_ns
        if slot.is_listed:
            self._renew(slot)
            if slot.release > now:
                slot.release = _next_on_grid(now, period_ns)
            self._list(slot, slot.release, _next_on_grid(slot.release, period_ns))

    def rekey(self, slot: TaskSlot, key: tuple[int, int, str]) -> None:
        """Another place among tasks with the same deadline; what was released stays so."""
        if self.groups:
            self.part()
        slot.key = key
        if slot.is_listed:
            self._renew(slot)
            self._list(slot, slot.release, slot.deadline)

    def next_due(self, now: int) -> TaskSlot | None:
        """The slot to run now, or None; call `done` after its cycle."""
        if self.groups:
            self.part()
        releases, ready = self._releases, self._ready
        if self._coming:
            self._let_in(now)
        while releases and releases[0][0] <= now:
            release, deadline, crit, rank, name, epoch, slot = heappop(releases)
            if epoch == slot.epoch:
                if release == now and not ready:
                    return slot  # all that is due was released at this very instant, and lies in order already
                heappush(ready, (deadline, crit, rank, name, epoch, slot))
        while ready:
            deadline, crit, rank, name, epoch, slot = heappop(ready)
            if epoch == slot.epoch:
                if deadline > now:
                    return slot
                slot.skip(now)
                heappush(ready, (slot.deadline, crit, rank, name, epoch, slot))
        return None

    def done(self, slot: TaskSlot) -> None:
        """A cycle is over: the next release is its deadline."""
        slot.release = release = slot.deadline
        slot.deadline = deadline = release + slot.period
        crit, rank, name = slot.key
        heappush(self._releases, (release, deadline, crit, rank, name, slot.epoch, slot))

    def after(self, slot: TaskSlot, now: int) -> TaskSlot | None:
        """As `done`, then `next_due`: in one step where the next slot was released at this very instant."""
        releases = self._releases
        if self._ready or self._coming or not releases or releases[0][0] != now:
            self.done(slot)
            return self.next_due(now)
        slot.release = release = slot.deadline
        slot.deadline = deadline = release + slot.period
        crit, rank, name = slot.key
        first = heapreplace(releases, (release, deadline, crit, rank, name, slot.epoch, slot))
        following = first[6]
        if first[5] == following.epoch:
            return following
        return self.next_due(now)

    def next_release(self) -> int | None:
        """When something becomes due (a time in the past: now); None if nothing ever will."""
        if self.groups:
            return self.groups[0][0]
        if self._coming:
            return min(self._coming.values())
        ready, releases = self._ready, self._releases
        while ready and ready[0][-2] != ready[0][-1].epoch:
            heappop(ready)
        if ready:
            return ready[0][-1].release
        while releases and releases[0][-2] != releases[0][-1].epoch:
            heappop(releases)
        return releases[0][0] if releases else None

    # Groups

    def gathered(self) -> list[list[TaskSlot]]:
        """All that will ever be due, by periods; empty where slots of one period are not due together, or some now."""
        if self._ready or self._coming:
            return []
        periods: dict[int, list[_Release]] = {}
        for entry in sorted(entry for entry in self._releases if entry[-2] == entry[-1].epoch):
            periods.setdefault(entry[-1].period, []).append(entry)
        if any(entries[0][:2] != entries[-1][:2] for entries in periods.values()):
            return []
        return [[entry[-1] for entry in entries] for entries in periods.values()]

    def group(self, groups: Sequence[SlotGroup]) -> None:
        """From now on the slots that were gathered are due as these groups; who runs one moves it on in the heap."""
        self.groups += [(group.slots[0].release, group.slots[0].deadline, group) for group in groups]
        heapify(self.groups)
        self._releases.clear()

    def part(self) -> None:
        """Each slot is due by itself again."""
        groups = self.groups.copy()
        self.groups.clear()
        for release, deadline, group in groups:
            for slot in group.slots:
                self._list(slot, release, deadline)

    def part_at(self, place: int) -> TaskSlot:
        """The same within the first group: the slot at this place has its cycle now, those before it have had theirs.

        Returns it; call `done`, `after` or `leave` for it.
        """
        release, deadline, group = heappop(self.groups)
        self.part()
        for slot in group.slots[:place]:
            self._list(slot, deadline, deadline + group.period)
        for slot in group.slots[place + 1 :]:
            self._list(slot, release, deadline)
        slot = group.slots[place]
        slot.release, slot.deadline = release, deadline
        return slot

    def _list(self, slot: TaskSlot, release: int, deadline: int) -> None:
        slot.release, slot.deadline = release, deadline
        heappush(self._releases, (release, deadline, *slot.key, slot.epoch, slot))

    def _let_in(self, now: int) -> None:
        for slot in self._coming:
            slot.is_listed = True
            slot.release = now
            slot.deadline = _next_on_grid(now, slot.period)
            heappush(self._releases, (now, slot.deadline, *slot.key, slot.epoch, slot))
        self._coming.clear()

    def _renew(self, slot: TaskSlot) -> None:
        """Make all entries of the slot stale. Epochs are never given twice, so that two entries never compare equal."""
        self._epoch += 1
        slot.epoch = self._epoch


def _next_on_grid(now: int, period: int) -> int:
    return (now // period + 1) * period
