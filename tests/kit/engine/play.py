"""A playbook: the story of a run, told as news that the engine hears (>>) and orders that must follow (<<).

    assert Play(engine) >> Run() << Spawn(0, "move") >> Spawned(0, "move") << Switch(…) << Began(0, 0)

Every order must be told, in its order, before the next news; `assert` demands that none is left at the end.
"""

from collections import deque
from collections.abc import Iterable
from typing import Self, TypeVar

from msgspec.structs import fields

from onika.engine.engine import Engine
from onika.engine.news import News
from onika.engine.orders import Case, Order
from onika.wire.steer import Position, Steering
from onika.words.reason import Reason

Line = TypeVar("Line", News, Order)


class Play:
    """One story; a line that is not what the engine does raises AssertionError with the story so far."""

    def __init__(self, engine: Engine) -> None:
        self._engine = engine
        self._story: list[str] = []
        self._untold: deque[Order] = deque()

    def __rshift__(self, news: News | Iterable[News]) -> Self:
        for each in _listed(news):
            self._demand_all_told()
            self._story.append(f">> {each}")
            self._untold.extend(self._engine.feed(each))
        return self

    def __lshift__(self, order: Order | Iterable[Order]) -> Self:
        for each in _listed(order):
            issued = self._untold.popleft() if self._untold else None
            if issued is None or in_english(issued) != in_english(each):
                raise AssertionError(self._tell(f"expected {each}", f"found    {issued or 'no order'}"))
            self._story.append(f"<< {each}")
        return self

    def refuses(self, news: Steering, why: str) -> Self:
        """The user cannot do this now, for a reason that has these words in it; said all the same it is not done."""
        refusal = self._engine.refusal(news)
        if not refusal or why not in str(refusal):
            raise AssertionError(self._tell(f"expected {news} refused: {why}", f"found    {refusal or 'no refusal'}"))
        return self >> news

    def cases(self, flow: int) -> list[Case]:
        """What is ready for the end of the current action of a flow."""
        self._demand_all_told()
        return self._engine.cases(flow)

    def position(self, flow: int) -> Position:
        """Where a flow is."""
        self._demand_all_told()
        return self._engine.positions()[flow]

    def __bool__(self) -> bool:
        self._demand_all_told()
        return True

    def _demand_all_told(self) -> None:
        if self._untold:
            raise AssertionError(
                self._tell("expected no further order", *(f"found    {each}" for each in self._untold))
            )

    def _tell(self, *ending: str) -> str:
        return "\n".join(["the story went", *(f"  {line}" for line in self._story), "and then", *ending])


def in_english(order: Order) -> dict[str, object]:
    """An order with its sentences in English, which a story may tell as they are."""
    values = {field.name: getattr(order, field.name) for field in fields(order)}
    texts = {name: str(value) for name, value in values.items() if isinstance(value, Reason)}
    return {"order": type(order), **values, **texts}


def _listed(line: Line | Iterable[Line]) -> Iterable[Line]:
    return line if isinstance(line, Iterable) else (line,)
