"""The order of base directories that are open: that of the search path, then those beside it (reading 11)."""

from collections.abc import Iterable, Sequence
from pathlib import Path

from onika.store.base_directory import BaseDirectory


def with_base(bases: Sequence[BaseDirectory], base: BaseDirectory, search: Iterable[Path]) -> list[BaseDirectory]:
    """Open base directories and one more: where the search path has it, else last."""
    places = {path.resolve(): place for place, path in enumerate(search)}
    ranks = [places.get(other.path.resolve(), len(places)) for other in bases]
    place = places.get(base.path.resolve(), len(places))
    at = next((at for at, rank in enumerate(ranks) if rank > place), len(bases))
    return [*bases[:at], base, *bases[at:]]
