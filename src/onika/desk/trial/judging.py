"""Judges a run against a kept one: says in sentences what differs, and since when (requirement X07)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from onika.desk.trial.account import CompletedAction, Elements, FlowAccount, RunAccount
from onika.desk.trial.alignment import Pair, align
from onika.files.line import show_number
from onika.model.kept import Demand, KeptAction, KeptFlow, KeptRun

_SHOWN = 5
_ROUND = 1e-9  # what is lost in writing numbers down


@dataclass(frozen=True, slots=True)
class Verdict:
    """What is not as it was; nothing: the test is passed. Notes tell differences that change nothing."""

    failures: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    lasted_s: float = 0.0

    @property
    def is_passed(self) -> bool:
        """Whether everything holds."""
        return not self.failures


def judge(kept: KeptRun, account: RunAccount) -> Verdict:
    """Compare a run with what was kept of an earlier one."""
    if account.refusals:
        more = len(account.refusals) - _SHOWN
        sentences = [f"it is refused: {fault}" for fault in account.refusals[:_SHOWN]]
        return Verdict((*sentences, *([f"and for {more} more reasons: see onika check"] if more > 0 else [])))
    failures, notes = [], []
    if account.cause:
        failures.append(f"it does not come to its end: {account.cause}")
        failures += [f"before that: {text}" for text in dict.fromkeys(account.warnings)]
    parts = {part.subsystem: part for part in account.parts}
    for flow in kept.flows:
        part = parts.pop(flow.subsystem, None)
        if part is None:
            failures.append(f"{flow.subsystem}: expected a flow of {len(flow.actions)} actions, found none")
        else:
            judging = _Judging(flow, part, is_whole=not account.cause)
            judging.judge()
            failures += judging.failures
            notes += judging.notes
    failures += [
        f"{part.subsystem}: expected no such flow, found {len(part.passed)} actions"
        for part in parts.values()
        if part.passed
    ]
    failures += _meetings(kept, account) if not account.cause else ()
    failures += [
        f"at the end: expected {text}, found {value}" for text, value, holds in account.expectations if not holds
    ]
    if kept.digest and kept.digest != account.digest:
        notes.insert(
            0, f"the application is no more what it was when the run was kept ({kept.digest}, now {account.digest})"
        )
    return Verdict(tuple(failures), tuple(notes), account.lasted_s)


class _Judging:
    """One flow."""

    def __init__(self, flow: KeptFlow, part: FlowAccount, *, is_whole: bool) -> None:
        self._flow = flow
        self._part = part
        self._is_whole = is_whole
        self._where = flow.subsystem
        self._wrong: dict[str, list[tuple[str, str, str]]] = {}
        self.failures: list[str] = []
        self.notes: list[str] = []

    def judge(self) -> None:
        """Fill failures and notes."""
        self._robots()
        pairs = align([action.name for action in self._flow.actions], [passed.name for passed in self._part.passed])
        is_after_gap = False
        for at, pair in enumerate(pairs):
            if not self._is_whole and pair.done is None and all(pair.done is None for pair in pairs[at:]):
                self._unfinished(len(pairs) - at, pair)
                break
            is_after_gap = self._pair(pair, is_after_gap)
        if self._is_whole:
            self._demands(self._flow.at_end, self._part.at_end, _units(self._part.passed), "at the end")
        self.failures += [f"{self._where}: {_since(name, wrong)}" for name, wrong in self._wrong.items()]

    def _robots(self) -> None:
        if self._flow.robots and set(self._flow.robots) != set(self._part.robots):
            expected, actual = (
                ", ".join(" on ".join(robot) for robot in sorted(some)) or "none"
                for some in (self._flow.robots, self._part.robots)
            )
            self.failures.append(f"{self._where}: expected the robots {expected}; found {actual}")

    def _unfinished(self, count: int, pair: Pair) -> None:
        first = self._flow.actions[pair.kept or 0].name
        self.failures.append(f"{self._where}: {count} actions are not done, from {_named(pair.kept, first)} on")

    def _pair(self, pair: Pair, is_after_gap: bool) -> bool:
        """Judge one action; whether the next one starts from elsewhere."""
        if pair.kept is None:
            done = self._part.passed[pair.done or 0]
            name = _named(pair.done, done.name)
            self.failures.append(
                f"{self._where}: expected nothing more here, found {name} from {done.began_s:.2f} s on"
            )
            return True
        kept = self._flow.actions[pair.kept]
        if pair.done is None:
            self._missing(pair.kept, kept)
            return True
        self._both(pair.kept, kept, self._part.passed[pair.done], is_after_gap)
        return False

    def _missing(self, at: int, kept: KeptAction) -> None:
        if kept.is_on_way:
            self.notes.append(
                f"{self._where}: {_named(at, kept.name)} is left out; it was on the way only, what follows is judged"
            )
        else:
            self.failures.append(f"{self._where}: expected {_named(at, kept.name)}, found it missing")

    def _both(self, at: int, kept: KeptAction, done: CompletedAction, is_after_gap: bool) -> None:
        where = f"after {_named(at, kept.name)} at {done.ended_s:.2f} s"
        if kept.name != done.name:
            self.notes.append(f"{self._where}: {_named(at, kept.name)} is {done.name} now; what it does is judged")
        lasted = done.ended_s - done.began_s
        if abs(lasted - kept.lasts_s) > kept.within_s + _ROUND and not is_after_gap:
            expected = f"expected to last {_show(kept.lasts_s, kept.within_s)} s"
            self.failures.append(f"{self._where}: {_named(at, kept.name)}: {expected}, found {lasted:.3g} s")
        self._demands(kept.after, done.values, _units([done]), where)

    def _demands(self, demands: Sequence[Demand], values: Elements, units: Mapping[str, str], where: str) -> None:
        for demand in demands:
            for which, text in _objections(demand, values.get(demand.address), units.get(demand.address, "")):
                self._wrong.setdefault(demand.address, []).append((which, where, text))


def _objections(demand: Demand, values: tuple[float, ...] | None, unit: str) -> Iterator[tuple[str, str]]:
    """Why a value is not what it must be, and which element of it where that is to be said."""
    if values is None:
        yield "", "expected a value, found none: no task that is on writes it"
    elif demand.unit and demand.unit != unit:
        yield "", f"expected it in {demand.unit}, found it in {unit or 'no unit'}"
    elif len(values) != len(demand.values):
        yield "", f"expected {len(demand.values)} numbers, found {len(values)}"
    else:
        within = demand.tolerance + _ROUND
        wrong = [at for at, (a, b) in enumerate(zip(demand.values, values, strict=True)) if not abs(a - b) <= within]
        for at in wrong[:1]:
            others = len(wrong) - 1
            more = f", and {others} more element{'s' * (others > 1)}" if others else ""
            text = (
                f"expected {_show(demand.values[at], demand.tolerance)}, found {values[at]:.4g} {demand.unit}".rstrip()
            )
            yield f"[{at}]" if len(values) > 1 else "", text + more


def _since(name: str, wrong: Sequence[tuple[str, str, str]]) -> str:
    """The first time that a variable is wrong, and how often it is so later."""
    (which, where, text), *later = wrong
    times = f"{len(later)} time{'s' * (len(later) > 1)}"
    again = f"; since then wrong {times} more, last {later[-1][1]}" if later else ""
    return f"{name}{which} {where}: {text}{again}"


def _units(some: Sequence[CompletedAction]) -> dict[str, str]:
    units: dict[str, str] = {}
    for passed in some:
        for variable in passed.variables:
            names = (
                [variable.name]
                if len(variable.units) == 1
                else [f"{variable.name}[{at}]" for at in range(len(variable.units))]
            )
            units |= {name: variable.unit_of(name) for name in names}
    return units


def _meetings(kept: KeptRun, account: RunAccount) -> Iterator[str]:
    expected = [f"{meeting.tag} of {' and '.join(sorted(meeting.subsystems))}" for meeting in kept.meetings]
    met = [f"{meeting.tag} of {' and '.join(sorted(meeting.subsystems))}" for meeting in account.meetings]
    if expected != met:
        yield f"meetings: expected {', '.join(expected) or 'none'}; found {', '.join(met) or 'none'}"


def _named(at: int | None, name: str) -> str:
    return f"action {(at or 0) + 1} ({name})"


def _show(value: float, within: float) -> str:
    return show_number(value) + (f" ± {show_number(within)}" if within else "")
