"""Small programs with every interleaving of what tasks, users and faults can do, looked at exhaustively (R-X03).

What must hold after every single piece of news stands in `kit.engine.engine_sim`: no lost signal, no action begun twice
without a word, no order that a task cannot obey, exactly the right tasks ON. Here, what must hold of whole runs: every
run can be ended and completed from everywhere, nothing stands still that was not foretold.
"""

from dataclasses import dataclass, replace
from random import Random

import pytest

from kit.engine.engine_sim import RUNTIME, EngineSim
from kit.plans.program_tree import Act, Loop, Pick, Side, engine_for, planned
from onika.engine import news as told
from onika.engine.flow import FlowState
from onika.model.rules import meetings
from onika.wire import steer
from onika.words.reason import Reason

NOOP = Act(tasks=(), is_noop=True)
GRIP = Act(tasks=("grip", "arm"))
PROGRAMS = {
    "two flows that meet": ((Act(), Act("a")), (GRIP, Act("a"))),
    "tags in wrong order": ((Act("a"), Act("b")), (Act("b"), Act("a"))),
    "a wait for an ended flow": ((Act(), Act("a")), (Act(),)),
    "a loop with a meeting": ((Loop("l", (Act("a"), GRIP)),), (Loop("k", (Act(), Act("a"))),)),
    "a top-test loop": ((Loop("l", (Act(), GRIP), is_top=True), Act()),),
    "loops in loops": ((Loop("l", (Act(), Loop("k", (Act(), GRIP)), NOOP)), Act()),),
    "an endless loop": ((Loop("l", (NOOP, Act(), GRIP), is_top=True), Act()),),
    "a branch": ((Act(), Pick(((GRIP,), (), (Act("a"),)))), (Act("a"),)),
    "a nested parallel application": ((Side(((Act("n a"),), (Act(), Act("n a")))), Act()),),
    "one in a loop": ((Loop("l", (Side(((Act(),), (GRIP,))), Act())),),),
    "one beside a flow": ((Side(((Act(),), (GRIP,))), Act("a")), (Act("a"),)),
    "a breakpoint": ((Act(breakpoint=""), NOOP, Act("a")), (Act("a", breakpoint=""),)),
    "three flows": ((Act("a"),), (Act("a"), Act("b")), (Act("b"),)),
    "nothing at all": ((), (NOOP,)),
}


@dataclass(frozen=True)
class Budget:
    """How often something may happen that need not."""

    user: int = 0
    faults: int = 0


class Explorer:
    """Every state that one program can come to."""

    def __init__(self, trees, budget, passive=frozenset(), spawns_apart=False):
        self.plan = planned(*trees)
        self.theatre = EngineSim(self.plan, engine_for(self.plan, passive, stands_still=True), passive)
        self.loops = [
            any(type(instruction).__name__ in ("Again", "Unless") for instruction in flow.program)
            for flow in self.plan.flows
        ]
        self.widths = [
            max(
                (len(instruction.to) for instruction in flow.program if type(instruction).__name__ == "Choose"),
                default=1,
            )
            for flow in self.plan.flows
        ]
        self.budget = budget
        self.spawns_apart = spawns_apart
        self.states = 0
        self.steps = 0
        self.completed = 0
        self.still = []
        self.theatre.feed(told.Run())
        if not spawns_apart:
            self.hear_all()

    def explore(self, most=50_000):
        """Look at all, of which there may be so many."""
        assert self.wander(most), "more states than were meant"
        return self

    def wander(self, most):
        """Look at so many states, wherever they are; True if there are no more."""
        theatre, chance = self.theatre, Random(0)
        ahead, seen = [(theatre.take(), self.budget)], set()
        while ahead and len(seen) < most:
            place = chance.randrange(len(ahead))
            ahead[place], ahead[-1] = ahead[-1], ahead[place]
            taken, budget = ahead.pop()
            theatre.put_back(taken)
            key = (theatre.key(), budget)
            if key in seen:
                continue
            seen.add(key)
            self.look_at(taken, budget)
            for happening, left in list(self.happenings(budget)):
                theatre.put_back(taken)
                happening()
                self.steps += 1
                ahead.append((theatre.take(), left))
        self.states = len(seen)
        return not ahead

    # What can happen

    def happenings(self, budget):
        theatre = self.theatre
        if theatre.end or self.is_over() or (self.spawns_apart and self.has_begun()):
            return
        for address in theatre.speakers():
            yield lambda address=address: theatre.hear(address), budget
        for address in theatre.triggers_on():
            for value in self.values(address[0]):
                news = told.Finished(*address, *value)
                yield lambda address=address, news=news: theatre.say(address, news, "off"), budget
        yield from ((lambda act=act: theatre.feed(act), budget) for act in self.goes_on())
        for flow in range(len(self.plan.flows)):
            yield from ((happening, budget) for happening in self.prepared(flow))
        if budget.faults:
            for fault in self.faults():
                yield fault, replace(budget, faults=budget.faults - 1)
        if budget.user:
            for act in self.acts():
                yield lambda act=act: theatre.feed(act), replace(budget, user=budget.user - 1)

    def values(self, flow):
        yield 0, False
        if self.loops[flow]:
            yield 0, True
        for choice in range(1, self.widths[flow] + (self.widths[flow] > 1)):
            yield choice, False

    def prepared(self, flow):
        """The present action ends with the switch that was prepared for it: where all is heard, a unit may hold it."""
        theatre = self.theatre
        own = [task for (number, _), task in theatre.tasks.items() if number == flow]
        if theatre.is_ready(flow) or any(task.mail for task in own):
            return
        for case in theatre.engine.cases(flow):
            if theatre.tasks[flow, case.task].life != "on":
                continue
            value = case.choice or 0, bool(case.loop)
            yield lambda case=case, value=value: theatre.finish_ready(case, flow, *value)

    def goes_on(self):
        """Whoever stands still is let go on, sooner or later."""
        for flow, position in enumerate(self.theatre.engine.positions()):
            if self.theatre.is_ready(flow):
                continue
            if position.state == "paused":
                yield steer.Resume(position.subsystem)
            if position.state == "stopped":
                yield steer.Recover(position.subsystem)

    def acts(self):
        """All that the user may do now."""
        for flow, planned_flow in enumerate(self.plan.flows):
            if self.theatre.is_ready(flow):
                continue
            every = [
                steer.Pause(planned_flow.subsystem),
                steer.Resume(planned_flow.subsystem),
                steer.Step(planned_flow.subsystem),
                steer.Skip(planned_flow.subsystem),
                steer.Pass(planned_flow.subsystem),
            ]
            every += [steer.Leave(planned_flow.subsystem), steer.Recover(planned_flow.subsystem)]
            every += [steer.Skip(planned_flow.subsystem, index) for index in range(len(planned_flow.actions))]
            yield from (act for act in every if not self.theatre.engine.refusal(act))

    def faults(self):
        theatre = self.theatre
        for address, task in theatre.tasks.items():
            if address == RUNTIME or task.life in ("gone", "absent"):
                continue
            last = type(task.mail[-1]) if task.mail else None
            if task.life == "on":
                yield lambda one=address: theatre.say(one, told.Failed(*one, "broke"), "error")
                is_trigger = address in list(theatre.triggers_on())
                if not is_trigger:
                    yield lambda one=address: theatre.say(one, told.SwitchedOff(*one), "off")
                if address[1] == "arm":  # of no action the trigger, and says it all the same
                    yield lambda one=address: theatre.say(one, told.Finished(*one), "off")
            if last is told.TurnedOn:
                yield lambda one=address: theatre.say_instead(one, told.Refused(*one, "no"), "off")
            if last is told.Cleared:
                yield lambda one=address: theatre.say_instead(one, told.Failed(*one, "again"), "error")
                yield lambda one=address: theatre.say_instead(one, told.Refused(*one, "no"), "error")
            if last is told.Spawned and len(task.mail) == 1:
                yield lambda one=address: theatre.say_instead(one, told.Refused(*one, "no"), "absent")
            if last in (told.Finished, told.Spawned, told.TurnedOn):
                yield lambda one=address, task=task: theatre.say(one, task.mail[-1], task.life)
            yield lambda one=address: theatre.say(one, told.Killed(*one), "gone")

    # What must hold

    def look_at(self, taken, budget):
        theatre = self.theatre
        if theatre.end:
            self.completed += theatre.end.completed
            return
        if not theatre.has_news and not list(theatre.triggers_on()):
            self.still.append([position.state for position in theatre.engine.positions()])
        self.can_be_ended()
        theatre.put_back(taken)
        if not theatre.has_news and self.has_begun() and not self.is_over():
            self.can_be_completed()
            theatre.put_back(taken)

    def has_begun(self):
        return all(position.state != "spawning" for position in self.theatre.engine.positions())

    def is_over(self):
        """Whether all is being killed; `can_be_ended` hears the rest."""
        return any(position.state == "killing" for position in self.theatre.engine.positions())

    def hear_all(self):
        while speakers := self.theatre.speakers():
            self.theatre.hear(speakers[0])

    def can_be_ended(self):
        theatre = self.theatre
        theatre.feed(told.Abort(Reason.plain("stop")))
        self.hear_all()
        assert theatre.end, theatre.story
        assert not any(task.life in ("on", "off", "error") for a, task in theatre.tasks.items() if a != RUNTIME)

    def can_be_completed(self):
        """With the help of its user every run comes to its end, loops are left, nothing is aborted."""
        theatre = self.theatre
        for turn in range(60):
            self.hear_all()
            if theatre.end:
                assert theatre.end.completed, theatre.story
                return
            for address in list(theatre.triggers_on()):
                theatre.say(address, told.Finished(*address), "off")
            for planned_flow in self.plan.flows if turn > 20 else ():
                if not theatre.engine.refusal(steer.Leave(planned_flow.subsystem)):
                    theatre.feed(steer.Leave(planned_flow.subsystem))  # endless loops are left by the user
            if not theatre.has_news:
                self.help()
        raise AssertionError(f"{theatre.story}\nand comes to no end")

    def help(self):
        for position in self.theatre.engine.positions():
            act = {
                FlowState.PAUSED: steer.Resume(position.subsystem),
                FlowState.STOPPED: steer.Recover(position.subsystem),
                FlowState.WAITING: steer.Pass(position.subsystem),
                FlowState.RUNNING: steer.Skip(position.subsystem),
            }.get(FlowState(position.state))
            if act and not self.theatre.engine.refusal(act):
                self.theatre.feed(act)
                return


QUICK = sorted(PROGRAMS.keys() - {"a loop with a meeting", "a branch", "three flows"})
SMALL = sorted({*QUICK} - {"one beside a flow"})
LONG = {"a breakpoint", "a nested parallel application", "one in a loop", "two flows that meet"}
"""What takes longest to explore waits for the long tests."""
SPAWNED = ["two flows that meet", "one in a loop"]


@pytest.mark.parametrize("name", PROGRAMS)
def test_nothing_stands_still_that_was_not_foretold_and_the_other_way_round(name):  # R-X03
    explorer = Explorer(PROGRAMS[name], Budget()).explore()
    deadlocks = [fault for fault in meetings.findings(explorer.plan) if fault.reason.key.startswith("rules.tag")]
    stand = [states for states in explorer.still if not {"paused", "stopped"} & set(states) and {"done"} != set(states)]
    assert bool(stand) == bool(deadlocks)
    if any(not fault.is_note for fault in deadlocks):
        assert not explorer.completed


@pytest.mark.parametrize("name", QUICK)
def test_whatever_the_user_does_once_every_run_can_be_completed_and_ended(name):  # R-E07, R-E13
    assert Explorer(PROGRAMS[name], Budget(user=1)).explore().states


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name in LONG else name for name in SMALL]
)
def test_whatever_goes_wrong_once_every_run_can_be_ended(name):  # R-E08, R-E10
    assert Explorer(PROGRAMS[name], Budget(faults=1)).explore().states


@pytest.mark.parametrize("name", SPAWNED)
def test_whatever_goes_wrong_while_tasks_come_to_life_every_run_can_be_ended(name):  # R-E02
    assert Explorer(PROGRAMS[name], Budget(faults=1), spawns_apart=True).explore().states


@pytest.mark.parametrize("name", ["a top-test loop", pytest.param("a breakpoint", marks=pytest.mark.slow)])
def test_a_passive_task_may_fall_silent_at_any_time(name):  # reading 17
    passive = frozenset({(0, "arm")})
    assert Explorer(PROGRAMS[name], Budget(faults=1), passive).explore().states


@pytest.mark.parametrize("budget", [Budget(faults=1), Budget(user=1, faults=1)])
@pytest.mark.parametrize("name", sorted(LONG))
def test_in_hundreds_of_places_of_a_long_program_nothing_is_lost(name, budget):
    explorer = Explorer(PROGRAMS[name], budget)
    assert not explorer.wander(most=500)
    assert explorer.states == 500


@pytest.mark.slow
@pytest.mark.parametrize("name", ["an endless loop"])
def test_a_user_who_acts_while_something_goes_wrong_loses_nothing(name):
    assert Explorer(PROGRAMS[name], Budget(user=1, faults=1)).explore().states


@pytest.mark.slow
@pytest.mark.parametrize("budget", [Budget(user=1), Budget(user=2), Budget(faults=1), Budget(user=1, faults=1)])
@pytest.mark.parametrize("name", PROGRAMS)
def test_more_of_all_of_that_in_places_far_apart(name, budget):
    explorer = Explorer(PROGRAMS[name], budget)
    assert explorer.wander(most=20_000) or explorer.states == 20_000
