"""Who holds which subsystem, as it is known here: what is told becomes what is shown (requirement X12)."""

from collections.abc import Iterable, Mapping

from msgspec import structs

from onika.desk.environment.run_state.question import ask_view
from onika.wire import event, steer
from onika.wire.runtime_standing import Standing
from onika.wire.view import AskView, HoldView, RuntimeView

OFFER_S = 60.0
"""How long a runtime lets an offer stand."""


def surveyed(former: Mapping[str, HoldView], standing: Standing) -> dict[str, HoldView]:
    """As it stands; what was told of a holder who is the same one still counts."""
    holds = {}
    for subsystem in standing.subsystems:
        hold = former.get(subsystem.name, HoldView())
        if hold.holder != subsystem.holder:
            hold = HoldView(subsystem.holder, state=hold.state, asks=hold.asks)
        asks = _asks(hold, subsystem.asks) if subsystem.application else {}
        holds[subsystem.name] = structs.replace(
            hold, application=subsystem.application, asks=asks, on_loss=subsystem.on_loss
        )
    return holds


def with_question(runtime: RuntimeView, message: event.Asked) -> RuntimeView:
    """A task of an application asks; of one that is held by hand its document shows it."""
    former = runtime.holds.get(message.subsystem)
    if former is None or not former.application:
        return runtime
    asks = {**former.asks, message.task: ask_view(message)}
    return _with(runtime, message.subsystem, structs.replace(former, asks=asks))


def turned(runtime: RuntimeView, message: event.TaskState) -> RuntimeView:
    """A task has come into another state: if that is not ASKING, it asks for nothing any more."""
    former = runtime.holds.get(message.subsystem)
    if former is None or message.state == "ASKING" or message.task not in former.asks:
        return runtime
    asks = {name: ask for name, ask in former.asks.items() if name != message.task}
    return _with(runtime, message.subsystem, structs.replace(former, asks=asks))


def changed(runtime: RuntimeView, message: event.Held, me: str, at_s: float) -> RuntimeView:
    """Somebody else holds it, or nobody any more; who was silent, or is gone, is remembered."""
    former = runtime.holds.get(message.subsystem, HoldView())
    is_loss = bool(not message.holder and message.cause)
    return _with(
        runtime,
        message.subsystem,
        HoldView(
            message.holder,
            former.application,
            former.state,
            since_at_s=at_s,
            cause=message.cause,
            former=former.holder if is_loss else "",
            was_here=is_loss and bool(me) and former.holder == me,
            asks=former.asks,
            on_loss=former.on_loss,
        ),
    )


def offered(runtime: RuntimeView, message: event.Offered, at_s: float) -> RuntimeView:
    """A holder offers it, or does so no more."""
    former = runtime.holds.get(message.subsystem)
    if former is None:
        return runtime
    to, until_s = ("", 0.0) if message.outcome else (message.to, at_s + OFFER_S if at_s else 0.0)
    return _with(runtime, message.subsystem, structs.replace(former, offered_to=to, offered_until_s=until_s))


def moved(runtime: RuntimeView, message: event.Moved) -> RuntimeView:
    """A flow has come into another state."""
    former = runtime.holds.get(message.subsystem)
    if former is None or former.state == message.state:
        return runtime
    return _with(runtime, message.subsystem, structs.replace(former, state=message.state))


def placed(runtime: RuntimeView, positions: steer.Positions) -> RuntimeView:
    """Where the flows of applications are."""
    for flow in positions.flows:
        former = runtime.holds.get(flow.subsystem)
        if former is not None and former.state != flow.state:
            runtime = _with(runtime, flow.subsystem, structs.replace(former, state=flow.state))
    return runtime


def flows_with(holds: Mapping[str, HoldView], subsystem: str) -> tuple[str, ...]:
    """The subsystems of the application that runs in one of them, this one among them; none runs: this one."""
    former = holds.get(subsystem, HoldView())
    if not former.application:
        return (subsystem,)
    same = (former.application, former.holder)
    return tuple(name for name, hold in holds.items() if (hold.application, hold.holder) == same)


def _asks(former: HoldView, questions: Iterable[event.Asked]) -> dict[str, AskView]:
    """What is asked now; a question that is shown already stays the one that it is."""
    views = {question.task: ask_view(question) for question in questions}
    shown = {name: structs.replace(ask, present={}) for name, ask in former.asks.items()}
    return {name: former.asks[name] if shown.get(name) == view else view for name, view in views.items()}


def _with(runtime: RuntimeView, subsystem: str, hold: HoldView) -> RuntimeView:
    return structs.replace(runtime, holds={**runtime.holds, subsystem: hold})
