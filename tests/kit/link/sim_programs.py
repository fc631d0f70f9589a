"""What takes part in a simulated history: programs of honest parts or with mistakes planted, and their clocks."""

from collections.abc import Callable
from dataclasses import dataclass

from kit.link.sim_link import SimCarrier
from onika.link.channel import Channel
from onika.link.client import ClientEnd
from onika.link.runtime_port import MakeServer
from onika.link.server import ServerEnd
from onika.link.session import EnvironmentSession
from onika.link.session_channels import MakeClient, SessionChannels
from onika.link.sessions import Sessions

MakeEpoch = Callable[[int], str]


def name_epoch(life: int) -> str:
    """A name of its own for each life of the runtime."""
    return f"epoch-{life}"


@dataclass(frozen=True, slots=True)
class Programs:
    """What the two programs are made of; a test plants its mistakes here."""

    client: MakeClient = ClientEnd
    server: MakeServer = ServerEnd
    session_channels: type[SessionChannels] = SessionChannels
    sessions: type[Sessions] = Sessions
    epoch: MakeEpoch = name_epoch


HONEST = Programs()


class SimProgram:
    """A program: its clock, and whether it lives."""

    def __init__(self, clock_ns: int) -> None:
        self.clock_ns = clock_ns
        self.is_up = True


class SimEnvironment(SimProgram):
    """An environment: its side of the session and its present connections."""

    def __init__(self, number: int, name: str, session_channels: SessionChannels, clock_ns: int) -> None:
        super().__init__(clock_ns)
        self.number = number
        self.name = name
        self.session_channels = session_channels
        self.plugs: dict[Channel, SimCarrier] = {}
        self.blind_ns = 0
        """Until then nothing from it arrives."""
        self.deaf_ns = 0
        """Until then nothing arrives at it."""


class SimRuntime(SimProgram):
    """A runtime: its sessions and their present connections."""

    def __init__(self, sessions: Sessions, clock_ns: int) -> None:
        super().__init__(clock_ns)
        self.sessions = sessions
        self.plugs: dict[tuple[EnvironmentSession, Channel], SimCarrier] = {}
