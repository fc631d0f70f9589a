"""The driver of a runtime, as its program sees it: where everything happens, in wall or in virtual time."""

from collections.abc import Callable, Iterable, Mapping
from typing import Protocol

from onika.host.inspection import InspectedDriver
from onika.host.recording.recorded_worlds import RecordedDriver
from onika.host.run.run_rendezvous import AppointedUnits
from onika.host.subsystems.subsystem_registry import Tables
from onika.host.units.unit_listener import UnitListener
from onika.ring.drive import DriveMode
from onika.wire.world_source import WorldSource
from onika.words.reason import Reason


class Driver(Tables, AppointedUnits, InspectedDriver, RecordedDriver, Protocol):
    """What a program asks of the units and worlds that it drives."""

    @property
    def digest(self) -> str:
        """Of everything that happened since `begin`, where that is the same every time; else empty."""
        ...

    @property
    def outside(self) -> tuple[str, ...]:
        """The tasks that had to do with the outside since `begin`, where without them it were the same every time."""
        ...

    def add_unit(self, name: str, answer: Callable[[Reason], None]) -> None:
        """Have one more processing unit, or a lost one anew; answered with nothing when it is up, else with why not."""
        ...

    def expect(self, worlds: Iterable[str]) -> None:
        """These worlds will be opened; nothing waits for what is prepared for that."""
        ...

    def offer(self, worlds: Iterable[WorldSource]) -> None:
        """These worlds are files; they are opened when a device of them is granted."""
        ...

    @property
    def opened(self) -> Mapping[str, str]:
        """The worlds that are open, each with what names the files that it was made of."""
        ...

    def listen(self, listener: UnitListener) -> None:
        """Tell this one what happens."""
        ...

    def begin(self) -> None:
        """A run starts now."""
        ...

    def advance(self, wall_ns: int) -> bool:
        """Let everything go on; False if nothing happens until somebody says something."""
        ...

    def stop(self) -> None:
        """Every drive in hold, latched."""
        ...

    def reset(self) -> None:
        """Motion is allowed again; nothing moves by itself."""
        ...

    def ask_modes(self, answer: Callable[[Mapping[str, DriveMode]], None]) -> None:
        """Say how every drive stands from within, by `world:device`, as soon as that is there; never waits."""
        ...

    def touch(self, world: str, part: str, value: float) -> None:
        """Touch a part of a world; raises ValueError with the reason why not."""
        ...

    def put_back(self, world: str) -> None:
        """Everything in a world to where it stood at the start; raises ValueError where only a person can do that."""
        ...

    def is_at_rest(self) -> bool:
        """Whether every drive holds."""
        ...

    def snapshots(self) -> dict[str, bytes]:
        """The worlds as they stand."""
        ...

    def standings(self) -> dict[str, tuple[Reason, ...]]:
        """What the worlds say in sentences of how they stand, as far as they say so."""
        ...

    def watched(self) -> dict[str, bool]:
        """Of each open world whether what happens in it that no program means is told."""
        ...
