"""An outside partner that a test steps through, in the same thread: it does only what the test says, when it says so.

outsider = FakePartner(tmp_path)
partner = Partner(outsider.address)
partner.ask("path")
connection = outsider.accept()
connection.answer(connection.read(), via=[])
"""

import json
import select
import socket
from pathlib import Path
from time import monotonic
from typing import Any, Self

from onika.runtime.partner.partner import Partner
from onika.words.reason import Reason

_TIMEOUT_S = 5.0


class PartnerConnection:
    """One connection of a task, seen from the partner's side."""

    def __init__(self, line: socket.socket) -> None:
        self._line = line
        line.settimeout(_TIMEOUT_S)
        self._lines = line.makefile("rb")

    def read(self) -> dict[str, Any]:
        """The next question."""
        question: dict[str, Any] = json.loads(self._lines.readline())
        return question

    def answer(self, question: dict[str, Any], **fields: Any) -> Self:
        """Answer it as one should."""
        return self.say(json.dumps({"id": question["id"], **fields}).encode() + b"\n")

    def say(self, data: bytes) -> Self:
        """Say anything."""
        self._line.sendall(data)
        return self

    def has_ended(self) -> bool:
        """Whether the task has hung up."""
        if not select.select([self._line], [], [], 0.0)[0]:
            return False
        try:
            return self._line.recv(1, socket.MSG_PEEK) == b""
        except ConnectionError:
            return True

    def close(self) -> None:
        """Hang up."""
        self._lines.close()
        self._line.close()


class FakePartner:
    """Listens in this folder as soon as it is made, or only after `open`."""

    def __init__(self, folder: Path, listens: bool = True) -> None:
        self._path = folder / "partner"
        self.address = f"unix:{self._path}"
        self._server: socket.socket | None = None
        self._connections: list[PartnerConnection] = []
        if listens:
            self.open()

    def open(self) -> None:
        """Listen."""
        self._server = socket.socket(socket.AF_UNIX)
        self._server.bind(str(self._path))
        self._server.listen()
        self._server.settimeout(_TIMEOUT_S)

    def accept(self) -> PartnerConnection:
        """The next connection; raises TimeoutError where no task connects."""
        if self._server is None:
            raise RuntimeError(Reason.of("runtime.bench_partner"))
        self._connections.append(PartnerConnection(self._server.accept()[0]))
        return self._connections[-1]

    def close(self) -> None:
        """Hang up everywhere, and listen no more."""
        for connection in self._connections:
            connection.close()
        self._connections.clear()
        if self._server is not None:
            self._server.close()
            self._path.unlink()
            self._server = None

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()


def wait(partner: Partner, most_s: float = _TIMEOUT_S) -> bool:
    """Wait until something has come of the partner's question, as an executive does; gives what `has_answered` says."""
    until = monotonic() + most_s
    while monotonic() < until:
        select.select([partner], [], [], until - monotonic())
        if partner.has_answered():
            return True
    return False
