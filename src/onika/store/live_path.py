"""A search path that grows and shrinks while somebody works with it: libraries of others come and go in a session."""

from collections.abc import Iterable, Iterator, Sequence
from typing import overload

from onika.store.base_directory import BaseDirectory


class LivePath(Sequence[BaseDirectory]):
    """Base directories in order. Several threads may read it; whoever reads it sees the former ones or the new ones."""

    def __init__(self, bases: Iterable[BaseDirectory]) -> None:
        self._bases = tuple(bases)

    def add(self, base: BaseDirectory) -> None:
        """One more, behind all others, unless it is there already."""
        if base not in self._bases:
            self._bases = (*self._bases, base)

    def remove(self, base: BaseDirectory) -> None:
        """One less."""
        self._bases = tuple(other for other in self._bases if other != base)

    def __iter__(self) -> Iterator[BaseDirectory]:
        return iter(self._bases)

    def __len__(self) -> int:
        return len(self._bases)

    @overload
    def __getitem__(self, at: int) -> BaseDirectory: ...
    @overload
    def __getitem__(self, at: slice) -> Sequence[BaseDirectory]: ...
    def __getitem__(self, at: int | slice) -> BaseDirectory | Sequence[BaseDirectory]:
        return self._bases[at]
