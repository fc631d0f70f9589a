"""Faults that follow from what is wrong with files of a world: a runtime that was not sent them cannot know (B07)."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path

from onika.store.site import Site
from onika.store.world_source import world_path
from onika.words.fault import Fault, Place

_OF_DEVICES = ("host.no_such_device", "host.no_world_of_device")
_OF_MODELS = "workcell.model_missing"


def with_causes(faults: Iterable[Fault], site: Site) -> list[Fault]:
    """The same faults; those of devices and models name those of the files that were left out for them."""
    every = list(faults)
    places: dict[str, list[Place]] = {}
    for fault in every:
        places.setdefault(fault.place.file, []).append(fault.place)
    return [_with_cause(fault, places, site) for fault in every]


def _with_cause(fault: Fault, places: Mapping[str, list[Place]], site: Site) -> Fault:
    file = _left_out(fault, site)
    causes = places.get(str(file), []) if file is not None else []
    return replace(fault, because=(*fault.because, *causes)) if causes else fault


def _left_out(fault: Fault, site: Site) -> Path | None:
    """The file that would have to be there: the text of a world, or a model, beside what names it."""
    args = fault.reason.args
    if fault.reason.key in _OF_DEVICES:
        return world_path(str(args["device"]).partition(":")[0].partition("@")[0], site)
    if fault.reason.key == _OF_MODELS:
        return Path(fault.place.file).parent / str(args["name"]).partition("/")[2]
    return None
