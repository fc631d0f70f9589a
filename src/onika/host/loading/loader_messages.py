"""What the loader is asked about module code, and what it answers: the messages between it and its runtime (law 21)."""

from typing import Any

from msgspec import Struct

from onika.wire.plan import Code
from onika.wire.request import FaultText
from onika.wire.sheet import ModuleSheet
from onika.words.reason import Reason

Lines = tuple[tuple[str, tuple[str, ...]], ...]


class AskSheet(Struct, frozen=True, tag=True):
    """Ask for the sheet of a module."""

    code: Code


class AskConstants(Struct, frozen=True, tag=True):
    """Ask for a robot module's constants."""

    code: Code
    local: Lines


class AskReach(Struct, frozen=True, tag=True):
    """Ask which targets are out of reach."""

    code: Code
    constants: dict[str, Any]
    targets: list[tuple[str, list[Any]]]


class AskPoses(Struct, frozen=True, tag=True):
    """Ask for the poses of joint targets."""

    code: Code
    constants: dict[str, Any]
    targets: list[list[Any]]


class AskPostures(Struct, frozen=True, tag=True):
    """Ask for joint values for poses."""

    code: Code
    constants: dict[str, Any]
    poses: list[list[float]]


class AskFit(Struct, frozen=True, tag=True):
    """Ask why a device is not the one that a module means."""

    code: Code
    constants: dict[str, Any]
    device: str


class AskCompany(Struct, frozen=True, tag=True):
    """Ask why devices of a world cannot be used together, or what is odd about them in one flow."""

    world: str
    devices: tuple[str, ...]
    is_of_flow: bool = False


class TakeWorld(Struct, frozen=True, tag=True):
    """From now on a world is made of the files that come with this datagram; there is no answer."""

    world: str


class AskWorldFaults(Struct, frozen=True, tag=True):
    """Ask for all that is wrong with the files of a world."""

    world: str


class AskDevices(Struct, frozen=True, tag=True):
    """Ask for the devices of a world."""

    world: str


class AskKind(Struct, frozen=True, tag=True):
    """Ask whether a world is simulated."""

    world: str


class Sheet(Struct, frozen=True, tag=True):
    """The answer to AskSheet, and how long the module took to load where its libraries are there already."""

    sheet: ModuleSheet
    cost_ns: int = 0


class Constants(Struct, frozen=True, tag=True):
    """The answer to AskConstants."""

    values: dict[str, Any]


class Reach(Struct, frozen=True, tag=True):
    """The answer to AskReach: a reason for each target out of reach."""

    reasons: list[Reason | None]


class KnownPoses(Struct, frozen=True, tag=True):
    """The answer to AskPoses; None: the robot knows of no poses."""

    poses: list[list[float]] | None


class Postures(Struct, frozen=True, tag=True):
    """The answer to AskPostures: values, or a reason, for each; None: the robot knows of no poses."""

    found: list[list[float] | Reason] | None


class Objections(Struct, frozen=True, tag=True):
    """The answer to AskFit and AskCompany; none: nothing is wrong."""

    reasons: tuple[Reason, ...]


class Devices(Struct, frozen=True, tag=True):
    """The answer to AskDevices."""

    names: tuple[str, ...]


class WorldFaults(Struct, frozen=True, tag=True):
    """The answer to AskWorldFaults."""

    faults: tuple[FaultText, ...]


class Kind(Struct, frozen=True, tag=True):
    """The answer to AskKind."""

    is_simulated: bool


class UnusableModule(Struct, frozen=True, tag=True):
    """The module cannot be used."""

    fault: FaultText


OfModules = AskSheet | AskConstants | AskReach | AskPoses | AskPostures | AskFit
OfWorlds = AskDevices | AskCompany | AskKind | AskWorldFaults
Question = OfModules | OfWorlds
Answer = Sheet | Constants | Reach | Devices | KnownPoses | Postures | Objections | Kind | WorldFaults | UnusableModule
