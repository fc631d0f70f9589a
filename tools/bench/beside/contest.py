"""A contest: one piece of work, done by Onika and by peers, round about; and how it ended."""

from collections.abc import Callable
from dataclasses import dataclass, field
from statistics import median

from beside.contestant import Absent, Contestant, Figures
from beside.peers import why_absent
from beside.punctuality.lateness import is_fifo_granted


@dataclass(frozen=True, slots=True)
class Entrant:
    """Who takes part: name, module, the package it needs, and the goal: ours is at most `goal` times its figure."""

    name: str
    module: str
    package: str = ""
    goal: float | None = None


@dataclass(frozen=True, slots=True)
class Contest:
    """The work, the unit of its figure (less is better), its sizes, and what must be true of every round."""

    key: str
    title: str
    unit: str
    ours: Entrant
    peers: tuple[Entrant, ...]
    size: int
    quick_size: int
    check: Callable[[Figures], None] | None = None
    needs_fifo: bool = False
    """Whether it means nothing without SCHED_FIFO."""
    extras: tuple[tuple[str, str], ...] = ()
    """Further figures to print: name and heading."""


@dataclass(slots=True)
class Score:
    """What one entrant did; `absent` says why it did nothing."""

    entrant: Entrant
    version: str = ""
    absent: str = ""
    rounds: list[Figures] = field(default_factory=list)

    @property
    def figures(self) -> list[float]:
        """The figure of every round."""
        return [_number(one["figure"]) for one in self.rounds]

    @property
    def figure(self) -> float:
        """The median of its rounds."""
        return median(self.figures)

    def extra(self, name: str) -> float:
        """The median of a further figure."""
        return median(_number(one[name]) for one in self.rounds)


@dataclass(frozen=True, slots=True)
class Outcome:
    """How a contest ended."""

    contest: Contest
    ours: Score
    peers: tuple[Score, ...]

    def ratio(self, peer: Score) -> float:
        """Ours to the peer's, the median over rounds that lie side by side in time."""
        return median(mine / its for mine, its in zip(self.ours.figures, peer.figures, strict=True))


def hold(contest: Contest, rounds: int, *, is_quick: bool = False, alone: bool = False) -> Outcome:
    """Carry out a contest: every round asks everybody, each time beginning with another.

    Raises `Absent` where Onika itself cannot take part; of a peer that is a line of the outcome.
    """
    if contest.needs_fifo and not is_fifo_granted():
        raise Absent("SCHED_FIFO is not granted here")
    size = contest.quick_size if is_quick else contest.size
    scores = [Score(one) for one in (contest.ours, *(() if alone else contest.peers))]
    present: list[tuple[Score, Contestant]] = []
    try:
        for score in scores:
            _enter(score, present)
        for number in range(rounds + 1):  # the first one warms up
            turn = number % len(present) if present else 0
            for score, contestant in present[turn:] + present[:turn]:
                _round(contest, score, contestant, size, counts=number > 0)
            present = [(score, contestant) for score, contestant in present if not score.absent]
    finally:
        for _, contestant in present:
            contestant.end()
    if scores[0].absent:
        raise Absent(f"{contest.ours.name}: {scores[0].absent}")
    return Outcome(contest, scores[0], tuple(scores[1:]))


def _enter(score: Score, present: list[tuple[Score, Contestant]]) -> None:
    reason = why_absent(score.entrant.package)
    if reason:
        score.absent = reason
        return
    try:
        contestant = Contestant(score.entrant.module)
    except Absent as why:
        score.absent = str(why)
        return
    score.version = contestant.version
    present.append((score, contestant))


def _round(contest: Contest, score: Score, contestant: Contestant, size: int, counts: bool) -> None:
    try:
        found = contestant.measure(size)
        if contest.check is not None:
            contest.check(found)
    except Absent as why:
        score.absent = str(why)
        return
    if counts:
        score.rounds.append(found)


def _number(value: float | list[float]) -> float:
    assert isinstance(value, int | float), f"expected a number, found {value!r}"
    return float(value)
