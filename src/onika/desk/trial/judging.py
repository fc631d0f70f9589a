"""Judges a run against a kept one: says in sentences what differs, and since when (requirement X07)."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from onika.desk.trial.account import CompletedAction, Elements, FlowAccount, RunAccount
from onika.desk.trial.alignment import Pair, align
from onika.model.kept import Demand, KeptAction, KeptFlow, KeptMeeting, KeptRun
from onika.words.reason import Reason

_SHOWN = 5
_ROUND = 1e-9  # what is lost in writing numbers down


@dataclass(frozen=True, slots=True)
class Verdict:
    """What is not as it was; nothing: the test is passed. Notes tell differences that change nothing."""

    failures: tuple[Reason, ...] = ()
    notes: tuple[Reason, ...] = ()
    lasted_s: float = 0.0

    @property
    def is_passed(self) -> bool:
        """Whether everything holds."""
        return not self.failures


@dataclass(frozen=True, slots=True)
class _Mismatch:
    """A variable that was not what it must be: which element of it, after which action, and what it was."""

    element: str
    where: Reason
    what: Reason


def judge(kept: KeptRun, account: RunAccount) -> Verdict:
    """Compare a run with what was kept of an earlier one."""
    if account.refusals:
        return Verdict(tuple(_refused(account)))
    failures, notes = list(_not_ended(account)), list(_changed(kept, account))
    parts = {part.subsystem: part for part in account.parts}
    for flow in kept.flows:
        part = parts.pop(flow.subsystem, None)
        if part is None:
            failures.append(Reason.of("trial.flow_missing", flow=flow.subsystem, count=len(flow.actions)))
        else:
            judging = _Judging(flow, part, is_whole=not account.cause)
            judging.judge()
            failures += judging.failures
            notes += judging.notes
    failures += [
        Reason.of("trial.flow_strange", flow=part.subsystem, count=len(part.passed))
        for part in parts.values()
        if part.passed
    ]
    failures += _meetings(kept, account)
    failures += [
        Reason.of("trial.expectation", text=text, value=str(value))
        for text, value, holds in account.expectations
        if not holds
    ]
    return Verdict(tuple(failures), tuple(notes), account.lasted_s)


def _refused(account: RunAccount) -> Iterator[Reason]:
    """Why it did not begin, the first few reasons."""
    for fault in account.refusals[:_SHOWN]:
        yield Reason.of("trial.refused", fault=fault.sentence)
    more = len(account.refusals) - _SHOWN
    if more > 0:
        yield Reason.of("trial.refused_more", count=more)


def _not_ended(account: RunAccount) -> Iterator[Reason]:
    if account.cause:
        yield Reason.of("trial.not_ended", cause=account.cause)
        for warning in dict.fromkeys(account.warnings):
            yield Reason.of("trial.before", text=warning)


def _changed(kept: KeptRun, account: RunAccount) -> Iterator[Reason]:
    if kept.digest and kept.digest != account.digest:
        yield Reason.of("trial.application_changed", kept=kept.digest, now=account.digest)


class _Judging:
    """One flow."""

    def __init__(self, flow: KeptFlow, part: FlowAccount, *, is_whole: bool) -> None:
        self._flow = flow
        self._part = part
        self._is_whole = is_whole
        self._wrong: dict[str, list[_Mismatch]] = {}
        self.failures: list[Reason] = []
        self.notes: list[Reason] = []

    def judge(self) -> None:
        """Fill failures and notes."""
        self._robots()
        pairs = align([action.name for action in self._flow.actions], [passed.name for passed in self._part.passed])
        is_after_gap = False
        for at, pair in enumerate(pairs):
            if not self._is_whole and all(later.done is None for later in pairs[at:]):
                self._unfinished(len(pairs) - at, pair)
                break
            is_after_gap = self._pair(pair, is_after_gap)
        if self._is_whole:
            at_end = Reason.of("trial.at_end")
            self._demands(self._flow.at_end, self._part.at_end, _units(self._part.passed), at_end)
        for name, wrong in self._wrong.items():
            self._fail(_since(name, wrong))

    def _fail(self, what: Reason) -> None:
        self.failures.append(Reason.of("trial.of_flow", flow=self._flow.subsystem, what=what))

    def _note(self, what: Reason) -> None:
        self.notes.append(Reason.of("trial.of_flow", flow=self._flow.subsystem, what=what))

    def _robots(self) -> None:
        if self._flow.robots and set(self._flow.robots) != set(self._part.robots):
            expected, actual = _robots_named(self._flow.robots), _robots_named(self._part.robots)
            self._fail(Reason.of("trial.robots", expected=expected, actual=actual))

    def _unfinished(self, count: int, pair: Pair) -> None:
        first = _named(pair.kept, self._flow.actions[pair.kept or 0].name)
        self._fail(Reason.of("trial.not_done", count=count, action=first))

    def _pair(self, pair: Pair, is_after_gap: bool) -> bool:
        """Judge one action; whether the next one starts from elsewhere."""
        if pair.kept is None:
            done = self._part.passed[pair.done or 0]
            action = _named(pair.done, done.name)
            self._fail(Reason.of("trial.nothing_more", action=action, seconds=done.began_s))
            return True
        kept = self._flow.actions[pair.kept]
        if pair.done is None:
            self._missing(pair.kept, kept)
            return True
        self._both(pair.kept, kept, self._part.passed[pair.done], is_after_gap)
        return False

    def _missing(self, at: int, kept: KeptAction) -> None:
        if kept.is_on_way:
            self._note(Reason.of("trial.left_out", action=_named(at, kept.name)))
        else:
            self._fail(Reason.of("trial.missing", action=_named(at, kept.name)))

    def _both(self, at: int, kept: KeptAction, done: CompletedAction, is_after_gap: bool) -> None:
        action = _named(at, kept.name)
        if kept.name != done.name:
            self._note(Reason.of("trial.renamed", action=action, name=done.name))
        lasted = done.ended_s - done.began_s
        if abs(lasted - kept.lasts_s) > kept.within_s + _ROUND and not is_after_gap:
            expected = _show(kept.lasts_s, kept.within_s)
            self._fail(Reason.of("trial.lasted", action=action, expected=expected, lasted=lasted))
        where = Reason.of("trial.after", action=action, seconds=done.ended_s)
        self._demands(kept.after, done.values, _units([done]), where)

    def _demands(self, demands: Sequence[Demand], values: Elements, units: Mapping[str, str], where: Reason) -> None:
        for demand in demands:
            for element, what in _objections(demand, values.get(demand.address), units.get(demand.address, "")):
                self._wrong.setdefault(demand.address, []).append(_Mismatch(element, where, what))


def _objections(demand: Demand, values: tuple[float, ...] | None, unit: str) -> Iterator[tuple[str, Reason]]:
    """Why a value is not what it must be, and which element of it where that is to be said."""
    if values is None:
        yield "", Reason.of("trial.value_none")
    elif demand.unit and demand.unit != unit:
        actual = Reason.plain(unit) or Reason.of("trial.unit_none")
        yield "", Reason.of("trial.unit_other", expected=demand.unit, actual=actual)
    elif len(values) != len(demand.values):
        yield "", Reason.of("trial.numbers", expected=len(demand.values), actual=len(values))
    else:
        yield from _deviation(demand, values)


def _deviation(demand: Demand, values: tuple[float, ...]) -> Iterator[tuple[str, Reason]]:
    """The first element that is too far from what it must be; none where all are near enough."""
    within = demand.tolerance + _ROUND
    wrong = [at for at, (a, b) in enumerate(zip(demand.values, values, strict=True)) if not abs(a - b) <= within]
    if not wrong:
        return
    at, others = wrong[0], len(wrong) - 1
    expected, actual = _show(demand.values[at], demand.tolerance), _found(values[at], demand.unit)
    what = Reason.of("trial.value", expected=expected, actual=actual)
    if others:
        what = Reason.of("trial.value_more", expected=expected, actual=actual, count=others)
    yield f"[{at}]" if len(values) > 1 else "", what


def _since(name: str, wrong: Sequence[_Mismatch]) -> Reason:
    """The first time that a variable is wrong, and how often it is so later."""
    first, *later = wrong
    variable = f"{name}{first.element}"
    if not later:
        return Reason.of("trial.variable_wrong", variable=variable, where=first.where, what=first.what)
    return Reason.of(
        "trial.variable_wrong_again",
        variable=variable,
        where=first.where,
        what=first.what,
        count=len(later),
        last=later[-1].where,
    )


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


def _meetings(kept: KeptRun, account: RunAccount) -> Iterator[Reason]:
    """What is not as it was of flows that waited for each other; nothing of a run that did not come to its end."""
    expected, met = _meetings_named(kept.meetings), _meetings_named(account.meetings)
    if expected != met and not account.cause:
        none = Reason.of("trial.none")
        yield Reason.of("trial.meetings", expected=expected or none, actual=met or none)


def _meetings_named(meetings: Sequence[KeptMeeting]) -> tuple[Reason, ...]:
    return tuple(
        Reason.of("trial.meeting", tag=meeting.tag, flows=tuple(sorted(meeting.subsystems))) for meeting in meetings
    )


def _robots_named(robots: Sequence[tuple[str, str]]) -> tuple[Reason, ...] | Reason:
    named = tuple(Reason.of("trial.robot", task=task, device=device) for task, device in sorted(robots))
    return named or Reason.of("trial.none")


def _named(at: int | None, name: str) -> Reason:
    return Reason.of("trial.action", number=(at or 0) + 1, name=name)


def _show(value: float, within: float) -> Reason:
    if within:
        return Reason.of("trial.value_about", value=value, within=within)
    return Reason.of("trial.value_exact", value=value)


def _found(value: float, unit: str) -> Reason:
    if unit:
        return Reason.of("trial.value_found_unit", value=value, unit=unit)
    return Reason.of("trial.value_found", value=value)
