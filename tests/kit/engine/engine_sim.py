"""A simulation of an engine and its tasks, which act when they like and whose every word may come late.

Orders act at once, news is heard one at a time, those of one task in their order; what a task has said before it was
told to come on anew is not heard any more, but that it has failed or is gone. What no task could obey, and what the
engine must never do, is an AssertionError with the story so far. It can be put back to what it was.
"""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Any

from msgspec import structs

from kit.engine.engine_memory import EngineMemory, Memory
from onika.engine import news as told
from onika.engine.engine import Engine
from onika.engine.flow import FlowState
from onika.engine.news import News
from onika.engine.orders import (
    Began,
    Case,
    Clear,
    Done,
    End,
    Kill,
    Moved,
    Off,
    Order,
    RunNote,
    Settle,
    Spawn,
    Switch,
    Together,
)
from onika.wire import steer
from onika.wire.plan import Plan, PlannedAction
from onika.words.reason import Reason

Address = tuple[int, str]
RUNTIME: Address = (-1, "")
"""Who says that everything has settled."""


Story = tuple[str, "Story"] | None
"""What was told, the latest line first; so that stories with one beginning share it."""


@dataclass(frozen=True, slots=True)
class Task:
    """A simulated task."""

    life: str = "absent"
    """absent, off, on, error or gone."""
    mail: tuple[News, ...] = ()
    """What it has said and nobody has heard yet."""
    may_end: bool = False
    """Whether its next finish has to end the present action."""
    fell: bool = False
    """Whether it went off by itself since it last came on."""


@dataclass(frozen=True, slots=True)
class SimState:
    """Everything that may change but the engine: tasks, the present action of each flow, what excuses a repetition."""

    tasks: tuple[tuple[Address, Task], ...]
    open: tuple[int | None, ...]
    excused: tuple[bool, ...]
    end: End | None
    ready: tuple[tuple[int, Switch], ...]


@dataclass
class EngineSim:
    """One performance."""

    plan: Plan
    engine: Engine
    passive: frozenset[Address] = frozenset()
    _story: Story = None

    def __post_init__(self) -> None:
        self._memory = EngineMemory(self.engine)
        self.tasks = {(n, task.name): Task() for n, flow in enumerate(self.plan.flows) for task in flow.tasks}
        self.tasks[RUNTIME] = Task("off")
        self.open: list[int | None] = [None] * len(self.plan.flows)
        self._excused = [False] * len(self.plan.flows)
        self.end: End | None = None
        self._announced: tuple[int, ...] = ()
        self._ready: dict[int, Switch] = {}
        self._started: set[Address] = set()

    @property
    def story(self) -> str:
        """All that has happened, a line for each."""
        lines, rest = [], self._story
        while rest is not None:
            line, rest = rest
            lines.append(line)
        return "\n".join(["the story went", *reversed(lines)])

    def _tell(self, line: str) -> None:
        self._story = (line, self._story)

    # As it was

    def take(self) -> tuple[Memory, SimState, Story]:
        """Everything as it is now."""
        return self._memory.take(), self._scene(), self._story

    def put_back(self, taken: tuple[Memory, SimState, Story]) -> None:
        """As it was when that was taken."""
        memory, scene, self._story = taken
        self._memory.put_back(memory)
        self.tasks = dict(scene.tasks)
        self.open, self._excused = list(scene.open), list(scene.excused)
        self.end = scene.end
        self._ready = dict(scene.ready)

    def key(self) -> tuple[Any, ...]:
        """Equal where the same can happen from now on."""
        return self._memory.key(), self._scene()

    def _scene(self) -> SimState:
        return SimState(
            tuple(self.tasks.items()), tuple(self.open), tuple(self._excused), self.end, tuple(self._ready.items())
        )

    # What can happen

    @property
    def has_news(self) -> bool:
        """Whether anything was said that nobody has heard."""
        return any(task.mail for task in self.tasks.values())

    def speakers(self) -> list[Address]:
        """Who has something to say."""
        speaking = [address for address, task in self.tasks.items() if task.mail]
        return [speaker for speaker in speaking if speaker[0] not in self._ready or self._tells_switch(speaker)]

    def is_ready(self, flow: int) -> bool:
        """Whether a prepared switch was carried out of which the engine has not heard; its user has to wait."""
        return flow in self._ready

    def _tells_switch(self, address: Address) -> bool:
        return any(isinstance(letter, told.Finished) and letter.switched for letter in self.tasks[address].mail)

    def triggers_on(self) -> Iterator[Address]:
        """The triggers of present actions, that may end them."""
        for flow, index in enumerate(self.open):
            if index is not None and flow not in self._ready:
                for task in self.action(flow, index).tasks[:1]:
                    if self.tasks[flow, task].life == "on":
                        yield flow, task

    def on(self) -> list[Address]:
        """The tasks that are ON."""
        return [address for address, task in self.tasks.items() if task.life == "on"]

    def action(self, flow: int, index: int) -> PlannedAction:
        """An action of a flow."""
        return self.plan.flows[flow].actions[index]

    def flow(self, subsystem: str) -> int:
        """The number of the flow that has this subsystem."""
        return next(number for number, planned in enumerate(self.plan.flows) if planned.subsystem == subsystem)

    def state(self, flow: int) -> FlowState:
        """The state of a flow, as the engine tells it."""
        return FlowState(self.engine.positions()[flow].state)

    # What happens

    def feed(self, news: News) -> list[Order]:
        """The engine hears it, and what it orders is done."""
        self._tell(f">> {news}")
        if isinstance(news, steer.Skip | steer.Recover) and not self.engine.refusal(news):
            flow = self.flow(news.subsystem)
            self._excused[flow] = isinstance(news, steer.Recover)
            self.open[flow] = self.open[flow] if isinstance(news, steer.Recover) else None
        orders = self.engine.feed(news)
        for order in orders:
            self._tell(f"<< {order}")
        for order in orders:
            self._carry_out(order)
        self._demand(not self._announced, f"switches of {self._announced} after Together")
        self._look_around()
        return orders

    def hear(self, address: Address) -> list[Order]:
        """The oldest unheard word of a task."""
        task = self.tasks[address]
        news, mail = task.mail[0], task.mail[1:]
        self.tasks[address] = replace(task, mail=mail)
        if not isinstance(news, told.Finished):
            return self.feed(news)
        return self._hear_finish(address, task, news)

    def _hear_finish(self, address: Address, task: Task, news: told.Finished) -> list[Order]:
        """It has to end the present action if it is of that, and else must not."""
        flow, counts = address[0], task.may_end
        is_alive = self.state(flow) not in (FlowState.KILLING, FlowState.ENDED)
        if counts:
            self.tasks[address] = replace(self.tasks[address], may_end=False)
        present = self.open[flow]
        orders = self.feed(news)
        self._demand(not (is_alive and flow in self._ready), "what was prepared, and was done, is not ordered")
        if news.switched:
            self._ready.pop(flow, None)
        done = [order for order in orders if isinstance(order, Done) and order.flow == flow]
        if counts and is_alive:
            self._demand(done[:1] == [Done(flow, present or 0)], f"{address} has finished, which went lost")
        if not counts:
            self._demand(not done, f"a late word of {address} has ended an action")
        return orders

    def say(self, address: Address, news: News, life: str) -> None:
        """A task does something by itself, and says so."""
        self._tell(f"   {address} is {life}: {type(news).__name__}")
        task = self.tasks[address]
        fell = task.fell or (life != "on" and not (task.may_end and isinstance(news, told.Finished)))
        self.tasks[address] = replace(task, life=life, mail=(*task.mail, news), fell=fell)

    def finish_ready(self, case: Case, flow: int, choice: int, loop: bool) -> None:
        """A trigger finishes, and the switch that was prepared for this is carried out with it, before it is heard."""
        address = (flow, case.task)
        self.say(address, told.Finished(flow, case.task, choice, loop, switched=1), "off")
        self._ready[flow] = case.switch
        for name in case.switch.off:
            self._off((flow, name))
        for start in case.switch.on:
            task = self.tasks[flow, start.task]
            self._demand(task.life == "off", f"{start.task} of flow {flow} is prepared to come on and is {task.life}")
            mail = (*task.mail, told.TurnedOn(flow, start.task))
            self.tasks[flow, start.task] = replace(task, life="on", mail=mail, fell=False)

    def say_instead(self, address: Address, news: News, life: str) -> None:
        """What a task has said last was this; nobody has heard the other."""
        task = self.tasks[address]
        self.tasks[address] = replace(task, mail=task.mail[:-1])
        self.say(address, news, life)

    # Orders

    def _carry_out(self, order: Order) -> None:
        self._demand(self.end is None, f"{order} after the end")
        match order:
            case Spawn():
                self._change((order.flow, order.task), "absent", "off", told.Spawned(order.flow, order.task))
            case Together():
                self._announced = order.flows
            case Switch():
                self._switch(order)
            case Off():
                self._off((order.flow, order.task))
            case Clear():
                self._clear((order.flow, order.task))
            case Kill():
                task = self.tasks[order.flow, order.task]
                is_known = any(isinstance(letter, told.Killed | told.Refused) for letter in task.mail)
                is_known = is_known and task.life in ("gone", "absent")
                self._demand(is_known or task.life in ("off", "on", "error"), f"{order} of one {task.life}")
                if not is_known:
                    self.say((order.flow, order.task), told.Killed(order.flow, order.task), "gone")
            case Began():
                self._began(order)
            case Done():
                self._demand(self.open[order.flow] == order.index, f"{order}, but {self.open[order.flow]} is open")
                self.open[order.flow] = None
            case Settle():
                self._demand(all(opening is None for opening in self.open), f"{order} with {self.open} open")
                self.say(RUNTIME, told.Settled(), "off")
            case End():
                alive = [a for a, task in self.tasks.items() if task.life not in ("gone", "absent") and a != RUNTIME]
                self._demand(not alive, f"the end, while {alive} live")
                self.end = order
            case Moved() | RunNote():
                pass

    def _switch(self, order: Switch) -> None:
        flow = order.flow
        self._started = {(flow, start.task) for start in order.on}
        if order.number:
            done = self._ready.pop(flow, None)
            self._demand(done == structs.replace(order, number=0), f"{order}, but {done} was carried out")
            return
        if self._announced:
            self._demand(flow in self._announced, f"{order} after Together of {self._announced}")
            self._announced = tuple(announced for announced in self._announced if announced != flow)
        for name in order.off:
            self._off((flow, name))
        for start in order.on:
            address, task = (flow, start.task), self.tasks[flow, start.task]
            mail = tuple(letter for letter in task.mail if isinstance(letter, told.Failed | told.Killed))
            if mail:
                refused = told.Refused(flow, start.task, Reason.plain("it is in error"))
                self.tasks[address] = replace(task, mail=(*mail, refused))
                continue
            is_known = not any(isinstance(letter, told.Cleared) for letter in task.mail)
            self._demand(task.life == "off" and is_known, f"{address} is turned on and is {task.life}, as was heard")
            on = (told.TurnedOn(flow, start.task),)
            self.tasks[address] = replace(task, life="on", mail=on, fell=False, may_end=False)

    def _clear(self, address: Address) -> None:
        if any(isinstance(letter, told.Cleared) for letter in self.tasks[address].mail):
            self.say(address, told.Refused(*address, Reason.plain("it is OFF")), "off")
        else:
            self._change(address, "error", "off", told.Cleared(*address))

    def _off(self, address: Address) -> None:
        task = self.tasks[address]
        is_known = task.life == "on" or any(not isinstance(letter, told.Spawned) for letter in task.mail)
        self._demand(is_known, f"{address} is turned off and is {task.life}, as was heard")
        life = "off" if task.life == "on" else task.life
        self.tasks[address] = replace(task, life=life, may_end=False, fell=False)

    def _began(self, order: Began) -> None:
        flow = order.flow
        if self.open[flow] is not None:
            self._demand(self._excused[flow], f"{order}, but {self.open[flow]} is open")
        self._excused[flow] = False
        self.open[flow] = order.index
        for name in self.action(flow, order.index).tasks[:1]:
            self._demand((flow, name) in self._started, f"{order}, but {name} is not told to come on anew")
            task = self.tasks[flow, name]
            self.tasks[flow, name] = replace(task, may_end=task.life == "on")

    def _change(self, address: Address, before: str, after: str, news: News) -> None:
        self._demand(
            self.tasks[address].life == before, f"{news} asked of {address} that is {self.tasks[address].life}"
        )
        self.say(address, news, after)
        self.tasks[address] = replace(self.tasks[address], fell=False)

    # What must always be so

    def _look_around(self) -> None:
        """Of a flow of which all is heard, exactly those tasks are ON that have to be."""
        for flow, position in enumerate(self.engine.positions()):
            state = FlowState(position.state)
            own = {name: task for (number, name), task in self.tasks.items() if number == flow}
            if state in (FlowState.KILLING, FlowState.ENDED) or any(task.mail for task in own.values()):
                continue
            is_told = (state is FlowState.WAITING) == bool(position.tag)
            self._demand(is_told, f"flow {flow} is {state.value} at tag {position.tag!r}")
            on = {name for name, task in own.items() if task.life == "on"}
            tasks = self.action(flow, position.action).tasks if position.action >= 0 else ()
            if state is FlowState.RUNNING:
                wanted = {name for name in tasks if not own[name].fell}
                self._demand(on == wanted, f"{on} are ON in flow {flow}, expected {wanted}")
            else:
                self._demand(not on & set(tasks[:1]), f"{tasks[:1]} is ON in flow {flow}, which is {state.value}")

    def _demand(self, truth: bool, otherwise: str) -> None:
        if not truth:
            raise AssertionError("\n".join([self.story, "and then", otherwise]))
