"""A fake runtime under an engine: carries its orders out on tasks that only have a state, and answers with news.

Orders act at once. News of different tasks overtake each other, as `choose` will have it; those of one task never.
What the engine may not order (a task ON twice, a switch of one that is not spawned, a second end) is an
AssertionError here.
"""

from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from enum import Enum

from onika.engine.engine import Engine
from onika.engine.news import (
    Abort,
    Asked,
    Cleared,
    Failed,
    Finished,
    Killed,
    News,
    Refused,
    Run,
    Settled,
    Spawned,
    SwitchedOff,
    TurnedOn,
)
from onika.engine.orders import (
    Began,
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
from onika.words.reason import Reason

Address = tuple[int, str]
"""A flow's number and the name of a task."""


class Fault(Enum):
    """What a task can do besides its duty, when it is turned ON."""

    ASK = "ask"
    """It asks first and is ON when answered."""
    FINISH_TWICE = "finish twice"
    """It says twice that it has finished."""
    SWITCH_OFF = "switch off"
    """It switches itself off."""
    FAIL = "fail"
    """It goes into error."""
    REFUSE = "refuse"
    """It will not come on."""


@dataclass(frozen=True, slots=True)
class Activation:
    """A task was turned ON, with this argument line, for the action that then began."""

    flow: int
    task: str
    arguments: str


class FakeRuntime:
    """Tasks that are absent, off or on; triggers finish as soon as they are ON."""

    def __init__(
        self,
        engine: Engine,
        triggers: frozenset[Address],
        choose: Callable[[int], int] = lambda choices: 0,
        faults: Callable[[Address], Fault | None] = lambda address: None,
    ) -> None:
        self._engine = engine
        self._triggers = triggers
        self._choose = choose
        self._faults = faults
        self._news: dict[Address | None, deque[tuple[News, int]]] = {}
        self._index: dict[int, int] = {}
        self._coming: list[Activation] = []
        self._in_error: set[Address] = set()
        self._rates: dict[Address, float | None] = {}
        self.living: set[Address] = set()
        self.on: set[Address] = set()
        self.orders: list[Order] = []
        self.on_during: dict[tuple[int, int], dict[str, float | None]] = {}
        """Who was ON when an action, by flow and index, began, and at what rate."""
        self.activations: dict[tuple[int, int], tuple[Activation, ...]] = {}
        """Who was turned ON for an action, in this order."""

    def run(self, abort_after: int | None = None) -> None:
        """Run until no more news comes; abort after so many pieces of news, if that is said."""
        self._feed(Run())
        count = 0
        while True:
            if count == abort_after:
                self._feed(Abort(Reason.plain("the user said so")))
            count += 1
            if not self._news:
                return
            self._feed(self._next())

    def _next(self) -> News:
        speakers: Sequence[Address | None] = [speaker for speaker in self._news if self._is_overdue(speaker)] or list(
            self._news
        )
        speaker = speakers[self._choose(len(speakers))]
        news, _ = self._news[speaker].popleft()
        if not self._news[speaker]:
            del self._news[speaker]
        return news

    def _is_overdue(self, speaker: Address | None) -> bool:
        """A word may be heard after the next action has begun, but then before all younger ones: a runtime takes in
        all that its units have said each time it looks."""
        return speaker is not None and self._news[speaker][0][1] < self._index.get(speaker[0], 0)

    def _feed(self, news: News) -> None:
        for order in self._engine.feed(news):
            _demand(not (self.orders and isinstance(self.orders[-1], End)), f"{order} after the end")
            self.orders.append(order)
            self._carry_out(order)

    def _carry_out(self, order: Order) -> None:
        match order:
            case Spawn():
                self.living.add((order.flow, order.task))
                self._say((order.flow, order.task), Spawned(order.flow, order.task))
            case Switch():
                self._switch(order)
            case Off():
                self.on.discard((order.flow, order.task))
            case Clear():
                self._in_error.discard((order.flow, order.task))
                self._say((order.flow, order.task), Cleared(order.flow, order.task))
            case Began():
                self._begin(order.flow, order.index)
            case Kill():
                self._kill((order.flow, order.task))
            case Settle():
                self._say(None, Settled())
            case End():
                _demand(not self.living, f"the end was said while {sorted(self.living)} live")
            case Together() | Done() | Moved() | RunNote():
                pass

    def _switch(self, order: Switch) -> None:
        for task in order.off:
            self.on.discard((order.flow, task))
        for start in order.on:
            address = (order.flow, start.task)
            _demand(address in self.living, f"{address} is switched ON and does not live")
            _demand(address not in self.on, f"{address} is switched ON and is ON")
            self._coming.append(Activation(order.flow, start.task, start.arguments))
            self._rates[address] = start.frequency
            if address not in self._in_error:
                self.on.add(address)
        for task, frequency in order.kept_rates:
            self._rates[order.flow, task] = frequency

    def _begin(self, flow: int, index: int) -> None:
        self._index[flow] = index
        self.on_during[flow, index] = {task: self._rates[flow, task] for number, task in self.on if number == flow}
        self.activations[flow, index] = tuple(self._coming)
        self._coming = []
        for each in self.activations[flow, index]:
            self._act((each.flow, each.task))

    def _act(self, address: Address) -> None:
        """What a task says when it is turned ON; a trigger finishes at once."""
        fault = self._faults(address)
        if fault is Fault.ASK:
            self._say(address, Asked(*address, Reason.plain("how far?")))
        if fault is Fault.REFUSE or address in self._in_error:
            self._fall(address, Refused(*address, Reason.plain("it will not")))
            return
        self._say(address, TurnedOn(*address))
        if fault is Fault.FAIL:
            self._in_error.add(address)
            self._fall(address, Failed(*address, Reason.plain("it broke")))
        elif fault is Fault.SWITCH_OFF:
            self._fall(address, SwitchedOff(*address))
        elif address in self._triggers:
            self._fall(address, *[Finished(*address)] * (2 if fault is Fault.FINISH_TWICE else 1))

    def _fall(self, address: Address, *news: News) -> None:
        """A task goes off by itself and says so."""
        self.on.discard(address)
        self._say(address, *news)

    def _kill(self, address: Address) -> None:
        _demand(address in self.living, f"{address} is killed and does not live")
        self.living.discard(address)
        self.on.discard(address)
        self._say(address, Killed(*address))

    def _say(self, speaker: Address | None, *news: News) -> None:
        said_at = 0 if speaker is None else self._index.get(speaker[0], 0)
        self._news.setdefault(speaker, deque()).extend((item, said_at) for item in news)


def _demand(truth: bool, otherwise: str) -> None:
    if not truth:
        raise AssertionError(otherwise)
