"""How a world stood at its start: what has left its place since, and who can put it back (law 18)."""

from typing import Protocol, runtime_checkable

from onika.ring.displacement import Displacement
from onika.words.reason import Reason


@runtime_checkable
class PlacedWorld(Protocol):
    """A world that knows what stands where at its start; others say nothing of it."""

    def places(self) -> tuple[Reason, ...]:
        """What stands where at the start, a sentence for each thing: for whoever puts it there by hand."""
        ...

    def displaced(self) -> tuple[Displacement, ...]:
        """What does not stand there now; none: all is as it was."""
        ...


@runtime_checkable
class ResettableWorld(Protocol):
    """A world that can put itself back."""

    def reset(self) -> None:
        """Everything where it was at the start, at rest; every drive holds, pressed buttons stay pressed."""
        ...


def displaced(world: object) -> tuple[Displacement, ...]:
    """What does not stand where it stood at the start, as far as the world knows."""
    return world.displaced() if isinstance(world, PlacedWorld) else ()


def put_back(name: str, world: object) -> None:
    """Everything to where it stood at the start; raises ValueError where only a person can, with what goes where."""
    if getattr(world, "is_simulated", False) is True and isinstance(world, ResettableWorld):
        world.reset()
        return
    places = world.places() if isinstance(world, PlacedWorld) else ()
    if places:
        raise ValueError(Reason.of("runtime.put_back_by_hand", world=name, places=places))
    raise ValueError(Reason.of("runtime.put_all_back_by_hand", world=name))
