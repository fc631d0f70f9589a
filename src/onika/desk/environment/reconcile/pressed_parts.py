"""Which parts of simulated workcells a hand holds pressed, as every page shows it."""

from collections.abc import Iterable
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.reconcile.watches import world_at
from onika.desk.environment.state.model import Model
from onika.wire import event


def with_pressed(model: Model, world: str, parts: Iterable[str]) -> Model:
    """The model in which just these parts of a world, which is of the station in focus, are pressed."""
    pressed = tuple(sorted(parts))
    if model.runtime.pressed.get(world, ()) == pressed:
        return model
    others = {name: held for name, held in model.runtime.pressed.items() if name != world}
    now = {**others, world: pressed} if pressed else others
    return replace(model, runtime=structs.replace(model.runtime, pressed=now))


def touched(model: Model, message: event.Touched) -> Model:
    """The model when a hand somewhere has pressed a part of an open world, or let it go."""
    world = world_at(model.station, message.world)
    if world not in model.runtime.worlds:
        return model
    others = {part for part in model.runtime.pressed.get(world, ()) if part != message.part}
    return with_pressed(model, world, others | {message.part} if message.value else others)
