"""What is known of the worlds of a runtime: whether they are simulated or real (requirement E09)."""

from collections.abc import Mapping
from dataclasses import replace
from typing import Literal

from msgspec import structs

from onika.desk.environment.state.model import Model

WorldKind = Literal["simulated", "real"]


def kinds(simulated: Mapping[str, bool]) -> dict[str, WorldKind]:
    """The words for what a runtime says of worlds."""
    return {name: "simulated" if is_simulated else "real" for name, is_simulated in simulated.items()}


def with_kinds(model: Model, simulated: Mapping[str, bool]) -> Model:
    """The model that knows more of the worlds of its runtime; the same where that is nothing new."""
    known = {**model.runtime.world_kinds, **kinds(simulated)}
    if known == model.runtime.world_kinds:
        return model
    return replace(model, runtime=structs.replace(model.runtime, world_kinds=known))
