"""Where an outside partner listens: `unix:PATH`, `unix:@NAME` or `tcp:HOST:PORT` (F04).

`unix:@NAME` is a name without a file, of Linux's abstract namespace. `{runtime}` in an address is a name that no other
runtime has, so that several on one machine do not share a partner.
"""

import os
import socket
from collections.abc import Mapping
from dataclasses import dataclass

from onika.words.reason import Reason
from onika.words.system_error import system_reason

OWN_NAME = "ONIKA_RUNTIME"
"""The environment variable in which a runtime tells its processes the name that no other runtime has."""


@dataclass(frozen=True, slots=True)
class PartnerAddress:
    """An address that can be connected to without asking anybody: names of machines were looked up when it was read."""

    words: str
    family: int
    place: str | tuple[str, int]

    @classmethod
    def parse(cls, written: str, environment: Mapping[str, str] = os.environ) -> "PartnerAddress":
        """Raises ValueError that says what was expected. To look a name up may take long: not for a cycle."""
        words = written.replace("{runtime}", environment.get(OWN_NAME, str(os.getpid())))
        kind, _, rest = words.partition(":")
        host, _, port = rest.rpartition(":")
        if kind == "unix" and rest.removeprefix("@"):
            return cls(words, socket.AF_UNIX, f"\0{rest[1:]}" if rest.startswith("@") else rest)
        if kind == "tcp" and host and port.isdecimal() and 0 < int(port) < 65536:
            try:
                addresses = socket.getaddrinfo(host.strip("[]"), int(port), type=socket.SOCK_STREAM)
            except OSError as wrong:
                raise ValueError(Reason.of("runtime.machine_name", host=host, why=system_reason(wrong))) from None
            family, _, _, _, place = addresses[0]
            return cls(words, family, place)  # type: ignore[arg-type]
        raise ValueError(Reason.of("runtime.partner_address", words=words))

    def call(self) -> tuple[socket.socket, bool]:
        """A connection and whether it stands already; else it stands, or not, when it can be written.

        Raises OSError where nobody listens.
        """
        line = socket.socket(self.family, socket.SOCK_STREAM)
        line.setblocking(False)
        try:
            if self.family != socket.AF_UNIX:
                line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            line.connect(self.place)
        except BlockingIOError:
            if self.family == socket.AF_UNIX:  # it listens, and takes nobody any more
                line.close()
                raise
            return line, False
        except OSError:
            line.close()
            raise
        return line, True
