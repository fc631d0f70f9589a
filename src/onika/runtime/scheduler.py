"""The scheduler of one RTPU: a release queue and a ready queue, earliest deadline first; sans-I/O (laws 1, 2).

A task in the scheduler is a mutable `TaskSlot`. Released slots wait by (deadline, criticality, rank, name), which fixes
the order at one instant whatever came before. A slot whose deadline has passed before it could run is late: the periods
it is late by are counted and skipped, and it runs once for the period that is open.
"""

from heapq import heappop, heappush, heapreplace


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


class Scheduler:
    """Slots by release time, then by deadline; time is handed in as integer nanoseconds."""

    def __init__(self) -> None:
        self._releases: list[tuple[int, int, int, int, str, int, TaskSlot]] = []
        self._ready: list[tuple[int, int, int, str, int, TaskSlot]] = []
        self._epoch = 0
        self._coming: dict[TaskSlot, int] = {}

    def enter(self, slot: TaskSlot, now: int) -> None:
        """Due at once, then on the common grid of multiples of the period.

        What enters waits outside until `next_due` is asked, and then enters with the time of that: tasks that come on
        together enter together, and what the `on` of one took makes no other one late.
        """
        slot.epoch = self._epoch = self._epoch + 1  # as `leave`, without a call: a switch enters many
        slot.is_listed = False
        self._coming[slot] = now

    def resume(self, slot: TaskSlot, now: int) -> None:
        """Due at the next point of the common grid, and no sooner."""
        self._coming.pop(slot, None)
        self._renew(slot)
        slot.is_listed = True
        slot.release = _next_on_grid(now, slot.period)
        slot.deadline = slot.release + slot.period
        heappush(self._releases, (slot.release, slot.deadline, *slot.key, slot.epoch, slot))

    def leave(self, slot: TaskSlot) -> None:
        """Not due any more; what still lies in the queues is stale by its epoch."""
        self._renew(slot)
        slot.is_listed = False
        self._coming.pop(slot, None)

    def change(self, slot: TaskSlot, period_ns: int, now: int) -> None:
        """Another period from now on; a release that is due already stays due, later ones lie on the new grid."""
        slot.period = period_ns
        if slot.is_listed:
            self._renew(slot)
            if slot.release > now:
                slot.release = _next_on_grid(now, period_ns)
            slot.deadline = _next_on_grid(slot.release, period_ns)
            heappush(self._releases, (slot.release, slot.deadline, *slot.key, slot.epoch, slot))

    def rekey(self, slot: TaskSlot, key: tuple[int, int, str]) -> None:
        """Another place among tasks with the same deadline; what was released stays so."""
        slot.key = key
        if slot.is_listed:
            self._renew(slot)
            heappush(self._releases, (slot.release, slot.deadline, *key, slot.epoch, slot))

    def next_due(self, now: int) -> TaskSlot | None:
        """The slot to run now, or None; call `done` after its cycle."""
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
