"""The engine tells the same story as the plain interpreter, whatever the tasks say and in whatever order."""

import pytest
from hypothesis import given, settings, strategies as st

from kit.examples import examples
from kit.plans import build
from onika.engine.engine import Engine
from onika.engine.news import Abort, Failed, Finished, Illegal, News, Refused, Run, Spawned, SwitchedOff, TurnedOn
from onika.engine.orders import Began, Done, Kill, Moved, Order, RunNote, Settle, Spawn, Switch, Together
from onika.words.reason import Reason

from .performance import Action, Event, Performance

Plan = list[list[build.Job]]

PASSIVE = "view"
FURTHER = "timer"
"""A trigger that takes no target."""

TELLS = {
    "engine.ends_no_action": "ignored",
    "engine.switched_itself_off": "fell silent",
    "engine.switched_off_not_passive": "fell silent",
    "engine.passive_in_error": "stays off",
    "engine.passive_stays_off": "stays off",
}

jobs = st.builds(
    lambda trigger, others, tag: build.job(trigger, *others, trigger=trigger, synch_tag=tag),
    trigger=st.sampled_from(["move", "grip"]),
    others=st.lists(st.sampled_from(["puma", "pd", PASSIVE, FURTHER]), unique=True, max_size=4),
    tag=st.sampled_from([None, None, "a", "b"]),
)
plans = st.lists(st.lists(jobs, min_size=1, max_size=4), min_size=1, max_size=3)
words = st.sampled_from([TurnedOn] * 10 + [Finished] * 12 + [SwitchedOff] * 2 + [Failed, Refused, Illegal, Abort])


class Stage:
    """Our engine, and who is ON by its orders."""

    def __init__(self, plan: Plan) -> None:
        numbers = range(len(plan))
        passive, further = [(number, PASSIVE) for number in numbers], [(number, FURTHER) for number in numbers]
        self.engine: Engine = build.engine(*plan, passive=passive, other_triggers=further)
        self.on: list[set[str]] = [set() for _ in plan]
        self._awake: list[set[str]] = [set() for _ in plan]
        """Who has come ON since it was last told to; what others say is of an activation before."""

    def begin(self, plan: Plan) -> list[Event]:
        for order in self.engine.feed(Run()):
            assert isinstance(order, Spawn)
        births = [Spawned(number, task) for number, flow in enumerate(plan) for task in build.names(flow)]
        return [event for birth in births for event in self.hear(birth)]

    def hear(self, news: News) -> list[Event]:
        if isinstance(news, TurnedOn):
            self._awake[news.flow] |= {news.task} & self.on[news.flow]
        if isinstance(news, Failed | Refused) or (
            isinstance(news, Finished | SwitchedOff) and news.task in self._awake[news.flow]
        ):
            self.on[news.flow].discard(news.task)
            self._awake[news.flow].discard(news.task)
        orders = _by_flow(self.engine.feed(news))
        if any(isinstance(order, Kill) for order in orders):
            assert all(isinstance(order, Kill) for order in orders)
            return [("ends",)]
        return [event for order in orders for event in self._seen(order, news)]

    def _seen(self, order: Order, news: News) -> list[Event]:
        match order:
            case Switch():
                self.on[order.flow] -= set(order.off)
                assert not self.on[order.flow] & {start.task for start in order.on}
                self.on[order.flow] |= {start.task for start in order.on}
                self._awake[order.flow] -= {*order.off, *(start.task for start in order.on)}
                return [("switches", order.flow, sorted(order.off), sorted(start.task for start in order.on))]
            case Began():
                return [("begins", order.flow, order.index)]
            case Done():
                return [("done", order.flow, order.index)]
            case Settle():
                return [("all done",)]
            case Together():
                return [("together", order.tag, sorted(order.flows))]
            case Moved(state="waiting"):
                assert order.text.key in ("", "engine.will_not_come")
                gone = list(order.text.args.get("flows", ()))
                return [("waits", order.flow, order.tag, list(order.waits_for), gone)]
            case Moved(state="running"):
                return [("runs again", order.flow)]
            case Moved(state="done"):
                return [("is done", order.flow)]
            case RunNote() if not isinstance(news, Run | Abort):
                return [(TELLS[order.text.key], order.flow, news.task)]
            case _:
                raise AssertionError(f"expected no {order} while the application runs")


def _by_flow(orders: list[Order]) -> list[Order]:
    """Switches of one instant may be ordered in any order of the flows."""
    first = next((place for place, order in enumerate(orders) if isinstance(order, Together)), len(orders)) + 1
    return orders[:first] + sorted(orders[first:], key=lambda order: order.flow)


def said(naive: Performance, news: News) -> list[Event]:
    match news:
        case TurnedOn():
            return naive.turned_on(news.flow, news.task)
        case Finished():
            return naive.finished(news.flow, news.task)
        case SwitchedOff():
            return naive.switched_off(news.flow, news.task)
        case Failed() | Refused():
            return naive.failed(news.flow, news.task)
        case _:
            return naive.ended()


def drawn_news(plan: Plan, naive: Performance, draw: st.DataObject) -> News:
    """What some task says; mostly what brings the story on, and mostly of a task that is ON."""
    running = [number for number, flow in enumerate(naive.flows) if flow.is_running]
    if running and draw.draw(st.integers(0, 3)):
        number = draw.draw(st.sampled_from(running))
        flow = naive.flows[number]
        trigger = draw.draw(st.sampled_from(flow.actions[flow.at].triggers))
        return (Finished if trigger in flow.said_so else TurnedOn)(number, trigger)
    kind = draw.draw(words)
    number = draw.draw(st.integers(0, len(plan) - 1))
    flow = naive.flows[number]
    silent, speaking = sorted(flow.on - flow.said_so), sorted(flow.said_so)
    likely = silent if kind is TurnedOn else speaking if kind is Finished else sorted(flow.on)
    task = draw.draw(st.sampled_from([*likely * 3, *build.names(plan[number])]))
    if kind is Abort:
        return Abort(Reason.plain("the user said so"))
    if kind in (Failed, Refused, Illegal):
        return kind(number, PASSIVE if PASSIVE in build.names(plan[number]) else task, Reason.plain("it broke"))
    return kind(number, task)


def tell(plan: Plan, draw: st.DataObject, words: int) -> None:
    actions = [
        [Action(job.tasks, tuple(t for t in job.tasks if t in (job.trigger, FURTHER)), job.synch_tag) for job in flow]
        for flow in plan
    ]
    naive, ours = Performance(actions, {PASSIVE}), Stage(plan)
    assert ours.begin(plan) == naive.begin()
    for _ in range(words):
        if naive.is_over:
            return
        news = drawn_news(plan, naive, draw)
        assert ours.hear(news) == said(naive, news), news
        if not naive.is_over:
            assert ours.on == [flow.on for flow in naive.flows], news


@given(plans, st.data())
@settings(max_examples=examples(120), deadline=None)
def test_any_story_of_any_plan_is_told_alike(plan: Plan, data: st.DataObject) -> None:
    tell(plan, data, 25)  # R-E02, R-E04, readings 16, 17, 26


@pytest.mark.slow
@given(plans, st.data())
@settings(max_examples=examples(4000), deadline=None)
def test_thousands_of_stories_are_told_alike(plan: Plan, data: st.DataObject) -> None:
    tell(plan, data, 60)  # R-E02, R-E04, readings 16, 17, 26
