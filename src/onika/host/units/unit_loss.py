"""The loss of a processing unit: whose drives trip with it, and which runs cannot go on (laws 17, 30)."""

from collections.abc import Iterable, Mapping


def dead_writers(unit: str, homes: Mapping[str, str]) -> tuple[str, ...]:
    """The devices whose writer died with a unit; `homes` names the unit of the task that has each device."""
    return tuple(device for device, home in homes.items() if home == unit)


def ends_with(unit: str, homes: Iterable[str]) -> bool:
    """Whether a run whose tasks live on these units ends with this one; with the device server (empty) every one."""
    return not unit or unit in homes
