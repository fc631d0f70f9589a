"""What the model is when a runtime is gone, and what its units have to do while it is there (requirement E10)."""

from collections.abc import Mapping
from dataclasses import replace

import msgspec

from onika.desk.environment.outcome.outcome import Done, EditEnd, No
from onika.desk.environment.reconcile import putting_back
from onika.desk.environment.reconcile.run_reducer import lost as run_lost
from onika.desk.environment.state.live import SubsystemFacts
from onika.desk.environment.state.model import Model
from onika.desk.run.runtime_conversation import black_box_in, in_short
from onika.wire import page, view
from onika.words.reason import Reason

_MUCH = 0.2


def lost(model: Model, reason: Reason) -> Done:
    """The runtime is gone: layouts stay, nothing lives, nothing is wanted; connecting again merges."""
    black_box = black_box_in(reason)
    documents = {
        key: replace(
            document,
            content=replace(document.content, wanted={}),
            live=SubsystemFacts(document.live.subsystem, "lost", black_box=black_box),
        )
        if document.live is not None and document.live.state == "live"
        else document
        for key, document in model.documents_here.items()
    }
    runtime = view.RuntimeView("lost", model.runtime.address, reason)  # there it is told in full
    done = run_lost(replace(model, documents={**model.documents, **documents}, runtime=runtime), in_short(reason))
    text = _gone(model)
    never = putting_back.lost(done.model)
    measuring = model.measuring if model.measuring and model.measuring.station == model.station else None
    awaited = (
        ()
        if measuring is None or measuring.awaits is None
        else ((EditEnd(measuring.awaits, model.station), No(reason)),)
    )
    says, news = (page.Say("error", text), *done.says, *never.says), (*done.news, *awaited)
    return replace(
        done, model=never.model if measuring is None else replace(never.model, measuring=None), says=says, news=news
    )


def _gone(model: Model) -> Reason:
    if model.station:
        return Reason.of("run.station_gone", name=model.station)
    address = model.runtime.address
    return Reason.of("run.runtime_gone", address=address) if address else Reason.of("run.runtime_ended")


def with_loads(model: Model, loads: Mapping[str, float], cycles_us: Mapping[str, float]) -> Done:
    """The shares of their time that units have used at last, and what cycles of modules took."""
    units = {
        name: msgspec.structs.replace(unit, load=round(loads.get(name, unit.load), 2))
        for name, unit in model.runtime.units.items()
    }
    runtime = model.runtime if units == model.runtime.units else msgspec.structs.replace(model.runtime, units=units)
    if runtime is model.runtime and cycles_us == model.cycles_us:
        return Done(model)
    return Done(replace(model, runtime=runtime, cycles_us=cycles_us))


NOT_MEASURED = (False, -1.0)


def is_other_quality(former: tuple[bool, float], now: tuple[bool, float]) -> bool:
    """Whether a link differs from what was told of it: in being heard, or by much in its round trip in ms."""
    return former[0] is not now[0] or abs(former[1] - now[1]) > max(1.0, _MUCH * former[1])


def with_quality(model: Model, is_cut: bool, round_trip_ms: float) -> Done:
    """The runtime as it is heard, and how long the way there and back takes."""
    if model.runtime.state != "linked":
        return Done(model)
    runtime = msgspec.structs.replace(model.runtime, is_cut=is_cut, round_trip_ms=round(round_trip_ms, 1))
    says: tuple[page.Say, ...] = ()
    if is_cut is not model.runtime.is_cut and model.station:
        reason = Reason.of("run.station_cut" if is_cut else "run.station_heard", name=model.station)
        says = (page.Say("warning" if is_cut else "info", reason),)
    return Done(replace(model, runtime=runtime), says=says)
