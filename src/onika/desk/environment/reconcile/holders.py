"""Who holds which subsystem, as it is known here: what is told becomes what is shown (requirement X12)."""

from collections.abc import Iterable, Mapping

from msgspec import structs

from onika.desk.environment.run_state.question import ask_view
from onika.wire import event, live, steer
from onika.wire.view import AskView, HoldView, RuntimeView

OFFER_S = 60.0
"""How long a runtime lets an offer stand."""


def surveyed(former: Mapping[str, HoldView], standing: live.Standing) -> dict[str, HoldView]:
    """As it stands; what was told of a holder who is the same one still counts."""
    found = {}
    for one in standing.subsystems:
        known = former.get(one.name, HoldView())
        if known.holder != one.holder:
            known = HoldView(one.holder, state=known.state, asks=known.asks)
        asks = _asks(known, one.asks) if one.application else {}
        found[one.name] = structs.replace(known, application=one.application, asks=asks, on_loss=one.on_loss)
    return found


def asked(runtime: RuntimeView, told: event.Asked) -> RuntimeView:
    """A task of an application asks; of one that is held by hand its document shows it."""
    known = runtime.holds.get(told.subsystem)
    if known is None or not known.application:
        return runtime
    asks = {**known.asks, told.task: ask_view(told)}
    return _with(runtime, told.subsystem, structs.replace(known, asks=asks))


def turned(runtime: RuntimeView, told: event.TaskState) -> RuntimeView:
    """A task has come into another state: if that is not ASKING, it asks for nothing any more."""
    known = runtime.holds.get(told.subsystem)
    if known is None or told.state == "ASKING" or told.task not in known.asks:
        return runtime
    asks = {name: one for name, one in known.asks.items() if name != told.task}
    return _with(runtime, told.subsystem, structs.replace(known, asks=asks))


def changed(runtime: RuntimeView, told: event.Held, me: str, at_s: float) -> RuntimeView:
    """Somebody else holds it, or nobody any more; who was silent, or is gone, is remembered."""
    known = runtime.holds.get(told.subsystem, HoldView())
    is_loss = bool(not told.holder and told.cause)
    return _with(
        runtime,
        told.subsystem,
        HoldView(
            told.holder,
            known.application,
            known.state,
            since_at_s=at_s,
            cause=told.cause,
            former=known.holder if is_loss else "",
            was_here=is_loss and bool(me) and known.holder == me,
            asks=known.asks,
            on_loss=known.on_loss,
        ),
    )


def offered(runtime: RuntimeView, told: event.Offered, at_s: float) -> RuntimeView:
    """A holder offers it, or does so no more."""
    known = runtime.holds.get(told.subsystem)
    if known is None:
        return runtime
    to, until_s = ("", 0.0) if told.outcome else (told.to, at_s + OFFER_S if at_s else 0.0)
    return _with(runtime, told.subsystem, structs.replace(known, offered_to=to, offered_until_s=until_s))


def moved(runtime: RuntimeView, told: event.Moved) -> RuntimeView:
    """A flow has come into another state."""
    known = runtime.holds.get(told.subsystem)
    if known is None or known.state == told.state:
        return runtime
    return _with(runtime, told.subsystem, structs.replace(known, state=told.state))


def placed(runtime: RuntimeView, positions: steer.Positions) -> RuntimeView:
    """Where the flows of applications are."""
    for one in positions.flows:
        known = runtime.holds.get(one.subsystem)
        if known is not None and known.state != one.state:
            runtime = _with(runtime, one.subsystem, structs.replace(known, state=one.state))
    return runtime


def flows_with(holds: Mapping[str, HoldView], subsystem: str) -> tuple[str, ...]:
    """The subsystems of the application that runs in one of them, this one among them; none runs: this one."""
    known = holds.get(subsystem, HoldView())
    if not known.application:
        return (subsystem,)
    same = (known.application, known.holder)
    return tuple(name for name, one in holds.items() if (one.application, one.holder) == same)


def _asks(known: HoldView, told: Iterable[event.Asked]) -> dict[str, AskView]:
    """What is asked now; a question that is shown already stays the one that it is."""
    found = {one.task: ask_view(one) for one in told}
    shown = {name: structs.replace(one, present={}) for name, one in known.asks.items()}
    return {name: known.asks[name] if shown.get(name) == one else one for name, one in found.items()}


def _with(runtime: RuntimeView, subsystem: str, hold: HoldView) -> RuntimeView:
    return structs.replace(runtime, holds={**runtime.holds, subsystem: hold})
