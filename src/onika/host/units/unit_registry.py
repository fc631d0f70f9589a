"""The RTPUs, by name, and the devices, as the runner sees them: the same in wall and in virtual time."""

from typing import Protocol

from onika.runtime import command


class Units(Protocol):
    """The RTPUs, by name, and the devices, as the runner sees them."""

    def send(self, rtpu: str, order: command.Command) -> None:
        """Give an RTPU a command."""
        ...

    def grant(self, rtpu: str, device: str) -> command.DeviceGrant:
        """Claim `world:device` for a task on this RTPU; raises ValueError with the reason."""
        ...

    def release(self, device: str) -> None:
        """Give a claimed device back: it holds."""
        ...
