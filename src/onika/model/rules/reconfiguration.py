"""What has to be switched to get from the tasks that are ON to the tasks that are wanted ON (§5.3.4)."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Change:
    """A reconfiguration: T1 - T2 goes off, T1 ∩ T2 is not touched, T2 - T1 comes on."""

    off: tuple[str, ...]
    keep: tuple[str, ...]
    on: tuple[str, ...]


def difference(on_now: Iterable[str], wanted: Sequence[str]) -> Change:
    """The change from `on_now` to `wanted`: `off` in the order of the former, `keep` and `on` in that of the latter."""
    before = dict.fromkeys(on_now)
    after = dict.fromkeys(wanted)
    return Change(
        off=tuple(name for name in before if name not in after),
        keep=tuple(name for name in after if name in before),
        on=tuple(name for name in after if name not in before),
    )
