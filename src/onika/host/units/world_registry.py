"""Worlds by name: whatever package offers one under the entry point `onika.worlds`; Onika itself knows none."""

from collections.abc import Collection
from importlib.metadata import entry_points
from typing import cast

from onika.runtime.bus import World
from onika.words.reason import Reason

GROUP = "onika.worlds"


def open_world(name: str, shake: int | None = None) -> World:
    """A new world; raises ValueError with the known names where there is none called so.

    `shake` is a seed: its things then stand a little elsewhere, where the world knows how (a method `shaken`).
    """
    offered = entry_points(group=GROUP)
    if name not in offered.names:
        worlds = tuple(sorted(offered.names)) or Reason.of("host.none_installed")
        raise ValueError(Reason.of("host.no_such_world", worlds=worlds, world=name))
    kind = offered[name].load()
    shaken = getattr(kind, "shaken", None) if shake is not None else None
    return cast(World, kind() if shaken is None else shaken(shake))


def refuse_unknown(world: str, opened: Collection[str]) -> None:
    """Raises ValueError where this world is not open."""
    if world not in opened:
        worlds = tuple(sorted(opened)) or Reason.of("host.none_is_open")
        raise ValueError(Reason.of("host.world_not_open", worlds=worlds, world=world))


def split(device: str) -> tuple[str, str]:
    """`world:device` in two; raises ValueError where it is not of this form."""
    world, colon, name = device.partition(":")
    if not (colon and world and name):
        raise ValueError(Reason.of("host.device_form", device=device))
    return world, name
