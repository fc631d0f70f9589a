"""Which station an act is about: its document's, or the one that it names (requirement F02)."""

from dataclasses import replace
from typing import Any

from msgspec import structs

from onika.desk.environment.outcome.outcome import Done, No
from onika.desk.environment.state.model import Model
from onika.wire import act, page
from onika.wire.view import Remedy
from onika.words.reason import Reason


def station_of(model: Model, command: act.AnyAct) -> str:
    """The station that is in focus while an act is carried out; empty: the first one."""
    named: str = getattr(command, "station", None) or ""
    if named:
        return named
    if isinstance(command, act.Scene | act.Touch):
        return command.world.rpartition("/")[0]
    if isinstance(command, act.SampleVariables):
        doc = next(iter(command.variables), "").partition("/")[0]
        return doc[1:].partition("@")[2] if doc.startswith("@") else _of_file(model, doc)
    return _of_file(model, getattr(command, "doc", ""))


def located(refusal: No, station: str) -> No:
    """A refusal at a station whose remedies are acts at the same."""
    if not station:
        return refusal
    return replace(refusal, remedies=tuple(_located(remedy, station) for remedy in refusal.remedies))


def of_station(done: Done) -> Done:
    """What a station has told, with its name in the lines that name no file; those of the first are as they were."""
    station = done.model.station
    if not station or not done.says:
        return done
    return replace(done, says=tuple(say if say.doc else _named(say, station) for say in done.says))


def _named(say: page.Say, station: str) -> page.Say:
    return structs.replace(say, text=Reason.of("run.what_why", what=station, why=say.text))


def _located(remedy: Remedy, station: str) -> Remedy:
    if getattr(remedy.act, "station", None) != "":
        return remedy
    asked: Any = remedy.act
    return structs.replace(remedy, act=structs.replace(asked, station=station))


def _of_file(model: Model, doc: str) -> str:
    """Where a configuration is turned on, and an application runs; of none the run that was begun last."""
    if doc in model.documents:
        return model.documents[doc].station
    run = model.run_of(doc) if doc else model.run
    if run is not None and not run.is_over:
        return run.station
    return (model.applications[doc].lone_station or "") if doc in model.applications else ""
