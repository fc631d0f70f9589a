"""Random stories of a subsystem held by hand, in virtual time, against a plain model of what must live and be ON."""

from dataclasses import dataclass, field

from hypothesis import example, given, settings, strategies as st
from msgspec import structs

from kit.examples import examples
from kit.runtime.live_edits import BROKEN, SOURCE, SULKY, live_edits_with_tasks
from onika.wire import event, live

NAMES = ("source", "other", "user", "reader", "counter", "sulky", "broken", "late")
SUPPLIERS = {"source", "other"}
SIZES = {"source": 2, "other": 3}
CONSUMERS = ("user", "reader")
WRITERS = {"source", "other", "sulky"}
"""Of LEVEL: one of them is ON at a time."""

SULKING = {"sulky", "late"}
"""Never come on."""

TAKES_NOTHING = """
    def take(self, old):
        raise RuntimeError("no")
"""


@dataclass
class Model:
    """What must live: states by task, and the N that counts."""

    states: dict[str, str] = field(default_factory=dict)
    size: int = 0

    def wrong(self, kill, spawn, on, off):
        """Whether a change can be seen to be wrong, or fails on its way."""
        return (
            self._is_refused(kill, spawn, on, off)
            or self._cannot_be_born(spawn)
            or self._cannot_be_switched(kill, spawn, on, off)
            or bool(on & SULKING)
        )

    def _is_refused(self, kill, spawn, on, off):
        living = set(self.states)
        after = (living - kill) | spawn
        is_of_the_living = kill <= living and off <= living and not spawn & (living - kill)
        return not is_of_the_living or not on <= after or after >= SUPPLIERS

    def _cannot_be_born(self, spawn):
        kept = self.size if SUPPLIERS & set(self.states) else 0
        size = next((SIZES[name] for name in SUPPLIERS & spawn), kept)
        return "broken" in spawn or ("user" in spawn and size > 4)

    def _cannot_be_switched(self, kill, spawn, on, off):
        """Whether nobody is switched, because of what can be seen to be wrong with one of them."""
        writing = {name for name, state in self.states.items() if state == "ON"} - kill - off
        has_supplier = bool(SUPPLIERS & (set(self.states) | spawn))
        for name in on:
            state = "WAITING" if name in spawn and name in CONSUMERS else self.states.get(name)
            if name not in spawn | off and state == "ON":
                return True
            if state == "WAITING" and not has_supplier:
                return True
        return len((writing | on) & WRITERS) > 1

    def fail(self, kill, spawn, on, off):
        """The states of tasks that a change leaves behind although it comes to nothing.

        Who was killed first is born again, and OFF. Who lived and did not come on is in ERROR.
        """
        if self._is_refused(kill, spawn, on, off):
            return {}
        left = {name: "OFF" for name in kill & spawn if self.states[name] == "ERROR"}
        if not self._cannot_be_born(spawn) and not self._cannot_be_switched(kill, spawn, on, off):
            left |= dict.fromkeys((on & SULKING) - spawn, "ERROR")
        self.states |= left
        return left

    def change(self, kill, spawn, on, off):
        """Carry it out: newcomers are born before the old ones are killed."""
        has_supplier = bool(SUPPLIERS & (set(self.states) | spawn))
        for name in kill:
            del self.states[name]
        for name in spawn:
            self.states[name] = "WAITING" if name in CONSUMERS else "OFF"
            if name in SUPPLIERS:
                self.size = SIZES[name]
        if has_supplier:
            for name in CONSUMERS:
                if self.states.get(name) == "WAITING":
                    self.states[name] = "OFF"
        for name in off:
            if self.states.get(name) == "ON":
                self.states[name] = "OFF"
        for name in on:
            self.states[name] = "ON"


def in_english(standings):
    return {task: structs.replace(standing, reason=str(standing.reason)) for task, standing in standings.items()}


def left_behind(standing, state):
    """How a task stands after a change that came to nothing."""
    return structs.replace(standing, state=state, reason="on: ModuleError: not today" if state == "ERROR" else "")


nobody = st.just(set())
singles = st.sets(st.sampled_from(NAMES), min_size=1, max_size=1)
subsets = st.sets(st.sampled_from(NAMES), max_size=3)
everyone = st.just(("spawn and on", {"source", "user", "reader", "counter"}))
steps = st.one_of(
    everyone,
    st.tuples(st.just("change"), subsets, subsets, subsets, subsets),
    st.tuples(st.just("change"), nobody, singles, nobody, nobody),
    st.tuples(st.just("change"), nobody, nobody, singles, subsets),
    st.tuples(st.just("spawn and on"), st.sets(st.sampled_from(NAMES[:5]), min_size=1, max_size=4)),
    st.tuples(st.just("exchange"), st.sampled_from([set(), {"broken"}, {"late"}]), st.booleans()),
    st.tuples(st.just("reinit"), st.sampled_from(sorted(SUPPLIERS)), st.sampled_from([1, 2, 3, 9])),
    st.tuples(st.just("swap"), st.sampled_from(NAMES)),
    st.tuples(st.just("refused swap"), st.sampled_from(NAMES)),
)


class Story:
    """One subsystem, and its model beside it."""

    def __init__(self):
        self.hand = live_edits_with_tasks(("rt0", "rt1"), reader="rt1", counter="rt1")
        self.hand.task("other", SOURCE, module="other", local={"SIZE": "3"}, rtpu="rt1")
        self.hand.task("sulky", SULKY)
        self.hand.task("late", SULKY.replace("LEVEL", "LATE"), rtpu="rt1")
        self.hand.task("broken", BROKEN.replace("LEVEL", "ELSE"))
        self.model = Model()

    def step(self, kind, *what):
        """Do something, and compare."""
        before, values = self.hand.standing(), self.values()
        self.left = {}
        self.hand.asker.server.events.clear()
        if kind == "change":
            kill, spawn, on, off = what
            touched = self.change(kill, spawn, on, off - kill)
        elif kind == "spawn and on":
            new = what[0] - set(self.model.states)
            touched = self.change(set(), new, {name for name in what[0] if self.model.states.get(name) != "ON"}, set())
        elif kind == "exchange":
            touched = self.exchange(*what)
        elif kind == "reinit":
            touched = self.reinit(*what)
        else:
            touched = self.swap(what[0], kind == "swap")
        if self.cause:
            left = {task: left_behind(before[task], state) for task, state in self.left.items()}
            assert in_english(self.hand.standing()) == in_english(before | left)
            assert self.values() == values
        turned = {state.task for state in self.hand.asker.of(event.TaskState)}
        assert turned <= touched
        self.compare()

    def change(self, kill, spawn, on, off):
        order = {"kill": sorted(kill), "spawn": sorted(spawn), "on": sorted(on), "off": sorted(off)}
        must_fail = self.model.wrong(kill, spawn, on, off)
        self.cause = self.hand.change(**order)
        assert bool(self.cause) == must_fail, (self.cause, order, self.model)
        learners = set(CONSUMERS) if spawn & SUPPLIERS else set()
        if self.cause:
            self.left = self.model.fail(kill, spawn, on, off)
        else:
            self.model.change(kill, spawn, on, off)
        return kill | spawn | on | off | learners

    def exchange(self, failing, with_reader):
        """The other supplier in place of the one that lives, perhaps with a reader of its dimension beside it."""
        here = set(self.model.states)
        gone = SUPPLIERS & here
        new = (SUPPLIERS - gone if gone else {"source"}) | (failing - here)
        more = {"reader"} if with_reader else set()
        off = {name for name in ("sulky",) if name in here}
        return self.change(gone | (more & here), new | more, (new & SUPPLIERS) | (failing & {"late"}) | more, off)

    def reinit(self, task, size):
        self.cause = self.hand.reinit(task, SIZE=str(size))
        there = task in self.model.states
        refused = size > 4 and self.model.states.get("user") not in (None, "WAITING")
        assert bool(self.cause) == (not there or refused), self.cause
        if not self.cause:
            self.model.size = size
        return {task, *CONSUMERS}

    def swap(self, task, is_good):
        hand, code = self.hand, self.hand.shop.code(task)
        source = code.source + ("" if is_good else TAKES_NOTHING)
        source += f"\n# {len(hand.asker.server.deliveries)}\n"
        planned = hand.shop.planned(task)
        hand.task(task, source, frequency=planned.frequency, module=planned.module, rtpu=planned.rtpu)
        self.cause = hand.swap(task)
        hand.task(
            task,
            code.source,
            frequency=planned.frequency,
            module=planned.module,
            rtpu=planned.rtpu,
            local={key: " ".join(words) for key, words in planned.local},
        )
        fails = task not in self.model.states or (not is_good and self.model.states[task] == "ON")
        assert bool(self.cause) == fails, (self.cause, self.model)
        return set()

    def compare(self):
        hand = self.hand
        assert hand.states == self.model.states
        hand.figures()
        hand.let_pass(0.2)
        for name, figure in hand.figures().items():
            assert (name, figure.miss) == (name, 0)
            assert (
                figure.cycle in ((10, 11) if name == "counter" else (20, 21))
                if figure.state == "ON"
                else figure.cycle == 0
            )
        on = {name for name, state in self.model.states.items() if state == "ON"}
        values = hand.values() if self.model.states else {}
        if {"user", "reader"} <= on:
            assert len(values["ROW"]) == self.model.size == values["N"]
            assert values["SUM"] == sum(values["ROW"])
        if self.model.states:
            assert hand.asker.ask(live.Check("s0")) == live.Findings(())

    def values(self):
        if not self.model.states:
            return {}
        return {name: value for name, value in self.hand.values().items() if name == "N"}


@settings(max_examples=examples(200), deadline=None)
@given(st.one_of(st.just([]), st.lists(everyone, min_size=1, max_size=1)), st.lists(steps, min_size=1, max_size=10))
@example([], [("change", set(), {"late"}, set(), set()), ("exchange", {"late"}, False)])
@example(
    [],
    [
        ("change", set(), {"late"}, set(), set()),
        ("change", set(), set(), {"late"}, set()),
        ("change", {"late"}, {"late"}, {"late"}, set()),
    ],
)
@example([], [("change", set(), {"reader"}, set(), set()), ("exchange", {"broken"}, True)])
def test_whatever_is_asked_what_lives_is_what_the_model_says(start, story):  # R-X10, R-A13, R-A05, law 22
    subsystem = Story()
    for step in (*start, *story):
        subsystem.step(*step)
    edited = [end for end in subsystem.hand.asker.server.deliveries if isinstance(end[2], event.Edited)]
    assert len({end[2].number for end in edited}) == len(edited)
