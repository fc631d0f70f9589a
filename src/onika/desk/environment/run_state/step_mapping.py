"""A recorded plan as one of the application that is open now: which step each recorded action is (requirement X05).

What was recorded names steps by the numbers of another session, or by the lines of a file. They are found again by
what their icons are called, one after the other in each flow.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field, replace
from difflib import SequenceMatcher

from msgspec import structs

from onika.desk.environment.run_state.membership import StepMembership
from onika.desk.environment.run_state.messages import IconWording
from onika.wire.plan import Plan, PlannedAction, PlannedFlow
from onika.words.fault import Place
from onika.words.reason import Reason

_NAMED = 3
"""How many of the actions that have no icon are named."""


@dataclass(frozen=True, slots=True)
class CurrentApplication:
    """An application as it is open now."""

    doc: str
    name: str
    plan: Plan | None
    """None: there is nothing in it that could be compiled."""
    belonging: StepMembership
    wording: IconWording


@dataclass(frozen=True, slots=True)
class StepMapping:
    """The recorded plan, its actions at the spots of the steps that they are now; without one, at none."""

    plan: Plan
    doc: str = ""
    belonging: StepMembership = field(default_factory=lambda: StepMembership({}, {}))
    wording: IconWording = field(default_factory=IconWording)
    notes: tuple[Reason, ...] = ()


def recast(recorded: Plan, present: CurrentApplication | None) -> StepMapping:
    """Find the steps; what has changed since is told."""
    bare = _placed(recorded, {})
    if present is None:
        return StepMapping(bare, wording=_told(IconWording(), recorded, bare), notes=_redirected(recorded))
    partners = _partners(recorded, present.plan) if present.plan is not None else {}
    plan = _placed(recorded, partners)
    wording = _told(present.wording, recorded, plan)
    notes = (*_changed(recorded, present, partners), *_redirected(recorded))
    return StepMapping(plan, present.doc, present.belonging, wording, notes)


# -- which action is which

_Partners = Mapping[tuple[int, int], PlannedAction]
"""By flow and index of the recorded plan, the action now."""


def _partners(recorded: Plan, now: Plan) -> dict[tuple[int, int], PlannedAction]:
    partners = {}
    for flow, other in _pairs(recorded, now):
        actions = now.flows[other].actions
        for at, there in _same(recorded.flows[flow], now.flows[other]):
            partners[flow, at] = actions[there]
    return partners


def _pairs(recorded: Plan, now: Plan) -> Iterator[tuple[int, int]]:
    """The flows that belong together: at the same place where they are alike, else those that are most alike."""
    left = {n for n, _ in enumerate(recorded.flows)}
    free = {n for n, _ in enumerate(now.flows)}
    for n in sorted(left & free):
        if _words(recorded.flows[n]) == _words(now.flows[n]):
            left.remove(n)
            free.remove(n)
            yield n, n
    likeness = [(_likeness(recorded.flows[a], now.flows[b]), -abs(a - b), a, b) for a in left for b in free]
    for ratio, _, a, b in sorted(likeness, reverse=True):
        if ratio > 0 and a in left and b in free:
            left.remove(a)
            free.remove(b)
            yield a, b


def _same(recorded: PlannedFlow, now: PlannedFlow) -> Iterator[tuple[int, int]]:
    """The actions that are the same, by their indices."""
    mine, other = _words(recorded), _words(now)
    if mine == other:
        yield from ((at, at) for at, _ in enumerate(mine))
        return
    for block in SequenceMatcher(None, mine, other, autojunk=False).get_matching_blocks():
        yield from ((block.a + k, block.b + k) for k in range(block.size))


def _likeness(planned_flow: PlannedFlow, other: PlannedFlow) -> float:
    return SequenceMatcher(None, _words(planned_flow), _words(other), autojunk=False).ratio()


def _words(flow: PlannedFlow) -> list[tuple[str, ...]]:
    """What its actions are called, and the applications and branches in which they stand."""
    return [(*action.within, action.name) for action in flow.actions]


# -- what is made of it


def _placed(recorded: Plan, partners: _Partners) -> Plan:
    flows = []
    for number, flow in enumerate(recorded.flows):
        actions = tuple(_at(action, partners.get((number, index))) for index, action in enumerate(flow.actions))
        flows.append(structs.replace(flow, actions=actions))
    return structs.replace(recorded, flows=tuple(flows))


def _at(planned_action: PlannedAction, partner: PlannedAction | None) -> PlannedAction:
    if partner is None:
        return structs.replace(planned_action, spot=())
    return structs.replace(planned_action, spot=partner.spot, place=partner.place, line=partner.line)


def _told(wording: IconWording, recorded: Plan, plan: Plan) -> IconWording:
    """The words of now, for what was told with the places of then."""
    recorded_speech = wording.hearing(recorded)
    actions = dict(recorded_speech.actions)
    for flow, now in zip(recorded.flows, plan.flows, strict=True):
        for action, placed in zip(flow.actions, now.actions, strict=True):
            shown = wording.action(placed)
            actions[f"{Place(action.place, action.line)} ({action.name})"] = actions[action.name] = shown
    return replace(recorded_speech, actions=actions)


def _changed(recorded: Plan, present: CurrentApplication, partners: _Partners) -> Iterator[Reason]:
    if present.plan is None:
        yield Reason.of("run.not_compiled", name=present.name)
        return
    every = [(number, index) for number, flow in enumerate(recorded.flows) for index, _ in enumerate(flow.actions)]
    lacking = [recorded.flows[number].actions[index] for number, index in every if (number, index) not in partners]
    more = sum(len(flow.actions) for flow in present.plan.flows) - len(partners)
    if lacking:
        names = tuple(dict.fromkeys(present.wording.action(planned_action) for planned_action in lacking))
        key = "run.changed_lacks_more" if len(names) > _NAMED else "run.changed_lacks"
        yield Reason.of(key, name=present.name, count=len(lacking), of=len(every), names=names[:_NAMED])
    elif more:
        yield Reason.of("run.changed_more", name=present.name, count=more)


def _redirected(recorded: Plan) -> tuple[Reason, ...]:
    """Who stood for whom; where there are several flows, in which."""
    replaced = [(number, name, old.name) for number, flow in enumerate(recorded.flows) for name, old in flow.replaced]
    replaced += [
        (number, driven, named)
        for number, flow in enumerate(recorded.flows)
        for named, driven in flow.worlds
        if named != driven
    ]
    if len(recorded.flows) > 1:
        return tuple(Reason.of("run.stood_for_in", name=name, old=old, number=number) for number, name, old in replaced)
    return tuple(Reason.of("run.stood_for", name=name, old=old) for _, name, old in replaced)
