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
        for key, document in model.documents.items()
    }
    runtime = view.RuntimeView("lost", model.runtime.address, reason)  # there it is told in full
    done = run_lost(replace(model, documents=documents, runtime=runtime), in_short(reason))
    is_elsewhere = bool(runtime.address)
    text = Reason.of("run.runtime_gone", address=runtime.address) if is_elsewhere else Reason.of("run.runtime_ended")
    never = putting_back.lost(done.model)
    measuring = model.measuring
    awaited = () if measuring is None or measuring.awaits is None else ((EditEnd(measuring.awaits), No(reason)),)
    says, news = (page.Say("error", text), *done.says, *never.says), (*done.news, *awaited)
    return replace(done, model=replace(never.model, measuring=None), says=says, news=news)


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
