"""A runtime that a site may launch, as its owner has listed it (requirement A15)."""

from dataclasses import dataclass

UNITS = ("rt0",)
"""Where nothing else is said."""


@dataclass(frozen=True, slots=True)
class Launch:
    """What is started under a name, and how.

    worlds          the only worlds that are opened in it; none named: any
    robot           the robot whose bookings it keeps; empty: it keeps none
    units           its processing units
    port            at which it listens; 0: any that is free
    needs_booking   whether only who has booked the robot may move it
    takes_code      whether module code is taken that comes from other machines
    stays           whether it stays when nobody is connected, whatever whoever launches it chooses
    lease_s         how long a holder may be silent; 0: as the way to him allows
    """

    name: str
    worlds: tuple[str, ...] = ()
    robot: str = ""
    units: tuple[str, ...] = UNITS
    port: int = 0
    is_virtual: bool = False
    needs_booking: bool = False
    takes_code: bool = False
    stays: bool = False
    lease_s: float = 0.0
