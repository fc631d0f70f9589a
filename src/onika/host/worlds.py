"""Worlds by name: whatever package offers one under the entry point `onika.worlds`; the house itself knows none."""

from importlib.metadata import entry_points
from typing import cast

from onika.runtime.bus import World

GROUP = "onika.worlds"


def open_world(name: str) -> World:
    """A new world; raises ValueError with the known names where there is none called so."""
    offered = entry_points(group=GROUP)
    if name not in offered.names:
        raise ValueError(f"expected a world ({', '.join(sorted(offered.names)) or 'none installed'}), found {name!r}")
    return cast(World, offered[name].load()())


def split(device: str) -> tuple[str, str]:
    """`world:device` in two; raises ValueError where it is not of this form."""
    world, colon, name = device.partition(":")
    if not (colon and world and name):
        raise ValueError(f"expected WORLD:DEVICE, found {device!r}")
    return world, name
