"""A kept run: what must hold when an application runs again (requirement X07)."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Demand:
    """What a variable, or one element of it as in `GRIP_MEZ[0]`, must be."""

    address: str
    values: tuple[float, ...]
    unit: str = ""
    tolerance: float = 0.0


@dataclass(frozen=True, slots=True)
class KeptAction:
    """An action that was carried out, how long it took, and what held when it had ended."""

    name: str
    lasts_s: float
    within_s: float
    after: tuple[Demand, ...] = ()
    is_on_way: bool = False
    """Whether it only leads to where the next one goes from: without it nothing else has to be different."""


@dataclass(frozen=True, slots=True)
class KeptFlow:
    """What happened on one subsystem: its robots as task and device, its actions in order, what held in the end."""

    subsystem: str
    robots: tuple[tuple[str, str], ...] = ()
    actions: tuple[KeptAction, ...] = ()
    at_end: tuple[Demand, ...] = ()


@dataclass(frozen=True, slots=True)
class KeptMeeting:
    """Flows that went on together from a tag."""

    tag: str
    subsystems: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class KeptRun:
    """A run of an application in virtual time, to be done again and compared."""

    application: str
    digest: str
    """Of all that the application consists of; empty: whatever it is."""
    flows: tuple[KeptFlow, ...]
    meetings: tuple[KeptMeeting, ...] = ()
    seed: int = 0
    settle_s: float = 0.5
    answers: tuple[tuple[str, str, str], ...] = ()
    """Task, name of an input, values."""
    expectations: tuple[str, ...] = ()
    redirects: tuple[str, ...] = ()
    """Other tasks in place of those of the application, as in `0:puma=scara`."""
