"""How tasks use a variable, counted as a `.conf` file counts (§A.2): six numbers, packed into one and added at once."""

from collections.abc import Iterable

from onika.model.configuration import Locus
from onika.model.port import PortKind

Uses = int
"""Six counts of 16 bits: tasks, inconst, outconst, invar, outvar, double_in; the sum of two counts both."""

_BITS = 16
_MASK = (1 << _BITS) - 1
_TASK = 1
_PIN = {
    PortKind.INCONST: 1 << _BITS,
    PortKind.OUTCONST: 1 << 2 * _BITS,
    PortKind.INVAR: 1 << 3 * _BITS,
    PortKind.OUTVAR: 1 << 4 * _BITS,
    PortKind.INBOTH: 1 << 5 * _BITS,  # in `double_in` only (reading 7)
    PortKind.OUTBOTH: 1 << 2 * _BITS,  # in `outconst` only (reading 7)
}


def of_task(pins: Iterable[tuple[str, PortKind]]) -> dict[str, Uses]:
    """What one task counts, by variable; `pins` are its variables with the kinds of their pins."""
    uses: dict[str, Uses] = {}
    for svar, kind in pins:
        uses[svar] = uses.get(svar, _TASK) + _PIN[kind]
    return uses


def of_locus(locus: Locus) -> Uses:
    """What a locus says."""
    return (
        locus.conns
        | locus.inconst << _BITS
        | locus.outconst << 2 * _BITS
        | locus.invar << 3 * _BITS
        | locus.outvar << 4 * _BITS
        | locus.double_in << 5 * _BITS
    )


def tasks(uses: Uses) -> int:
    """How many tasks use it."""
    return uses & _MASK


def apart(uses: Uses) -> tuple[int, ...]:
    """The six counts."""
    return tuple(uses >> _BITS * place & _MASK for place in range(6))
