"""Worlds by name: what packages offer under the entry point `onika.worlds`, then worlds of files (decision 49)."""

from collections.abc import Collection, Mapping
from importlib.metadata import EntryPoint, entry_points
from types import MappingProxyType
from typing import Any, cast

from onika.runtime.bus import World
from onika.wire.world_source import WorldSource
from onika.words.fault import Fault
from onika.words.reason import Reason

GROUP = "onika.worlds"
_MEMBERS = (*World.__annotations__, *(name for name in vars(World) if not name.startswith("_")))
"""What a world has to have: the attributes and methods of `World`."""
_OF_FILES = EntryPoint("files", "onika.workcell.filmed.filmed_world:FilmedWorld", GROUP)
"""What makes a world of files; it is there without being installed."""
_JUDGE = EntryPoint("judge", "onika.workcell.filmed.filmed_world:judged", GROUP)


def open_world(
    name: str,
    shake: int | None = None,
    files: WorldSource | None = None,
    values: Mapping[str, Mapping[str, float]] = MappingProxyType({}),
) -> World:
    """A new world; raises ValueError with the known names where there is none called so, or with what it lacks.

    A package that offers a world of this name comes before `files`.

    Of a simulated one, `boxes@NAME` is a copy of its own, in which nothing touches what is in `boxes`. `shake` is a
    seed: its things then stand a little elsewhere, where the world knows how (a method `shaken`). `values` are what is
    otherwise in it, by world and name (a method `vary`).
    """
    world = _made(name, shake, files)
    for value_name, value in values.get(_plain(name), {}).items():
        vary = getattr(world, "vary", None)
        if vary is None:
            raise ValueError(Reason.of("host.world_not_varied", world=name))
        vary(value_name, value)
    return world


def _made(name: str, shake: int | None, files: WorldSource | None) -> World:
    if is_of_files(name, files):
        return cast(World, _OF_FILES.load()(files, shake))
    kind = _kind(name)
    if _is_copy(name) and not _is_simulated(kind):
        raise ValueError(Reason.of("host.no_copy_of_real", world=name.partition("@")[0]))
    shaken = getattr(kind, "shaken", None) if shake is not None else None
    world = kind() if shaken is None else shaken(shake)
    lacking = tuple(member for member in _MEMBERS if not hasattr(world, member))
    if lacking:
        raise ValueError(Reason.of("host.world_lacks", world=name, kind=type(world).__qualname__, lacking=lacking))
    return cast(World, world)


def is_of_files(name: str, files: WorldSource | None) -> bool:
    """Whether a world is made of files that are there, and no package offers it."""
    return files is not None and _plain(name) == files.world and files.world not in offered_worlds()


def world_faults(files: WorldSource) -> tuple[Fault, ...]:
    """All that is wrong with the files of a world, and left out for that."""
    return cast(tuple[Fault, ...], _JUDGE.load()(files))


def faults_of(world: World) -> tuple[Fault, ...]:
    """All that is wrong with the files of a world that could be opened, and left out for that."""
    return cast(tuple[Fault, ...], getattr(world, "faults", ()))


def is_simulated(name: str, files: WorldSource | None = None) -> bool:
    """Whether a world only computes what it shows; one that does not say so counts as real.

    It is not opened for that. Raises ValueError where there is none called so.
    """
    return is_of_files(name, files) or _is_simulated(_kind(name))


def offered_worlds() -> tuple[str, ...]:
    """The names of the worlds that are installed; no code of them is executed for that."""
    return tuple(sorted(entry_points(group=GROUP).names))


def module_of(name: str) -> str:
    """The module that offers a world, also of a copy; empty where there is none. No code of it is executed for that."""
    return next((entry.module for entry in entry_points(group=GROUP, name=_plain(name))), "")


def refuse_unoffered(name: str, files: WorldSource | None = None) -> None:
    """Raises ValueError with the known names where no world is called so; no code of worlds is executed for that."""
    offered = offered_worlds()
    if _plain(name) not in offered and not is_of_files(name, files):
        raise ValueError(
            Reason.of("host.no_such_world", worlds=offered or Reason.of("host.none_installed"), world=name)
        )


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


def _kind(name: str) -> Any:
    """The class of a world, also of a copy."""
    refuse_unoffered(name)
    return entry_points(group=GROUP)[_plain(name)].load()


def _plain(name: str) -> str:
    """The name of the world that a copy is of."""
    return name.partition("@")[0] if _is_copy(name) else name


def _is_copy(name: str) -> bool:
    return all(name.partition("@"))


def _is_simulated(kind: Any) -> bool:
    return getattr(kind, "is_simulated", False) is True
