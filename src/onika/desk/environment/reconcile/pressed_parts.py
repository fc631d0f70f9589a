"""Which parts of simulated workcells a hand holds pressed, as every page shows it."""

from collections.abc import Iterable
from dataclasses import replace

from msgspec import structs

from onika.desk.environment.state.model import Model


def with_pressed(model: Model, world: str, parts: Iterable[str]) -> Model:
    """The model in which just these parts of a world, which is of the station in focus, are pressed."""
    pressed = tuple(sorted(parts))
    if model.runtime.pressed.get(world, ()) == pressed:
        return model
    others = {name: held for name, held in model.runtime.pressed.items() if name != world}
    now = {**others, world: pressed} if pressed else others
    return replace(model, runtime=structs.replace(model.runtime, pressed=now))
