"""One site of a campaign: its service, and the runtime that it launches for us."""

from contextlib import suppress
from pathlib import Path
from time import monotonic, sleep

from onika.desk.run.remote_runtime import RemoteRuntime
from onika.link.lost import LinkLost
from onika.link.starting.site_address import SiteAddress
from onika.link.starting.site_client import SiteClient
from onika.link.websocket_opening import WebSocketOpening
from onika.wire import event

LIST = "VERSION 2.0\n\nLAUNCH arm\nPORT 7996\nCODE yes\n\nEOF\n"
"""What each site launches."""


class FarSite:
    """Reached by `host`; `session` is ours with its runtime, once it was joined."""

    def __init__(self, number: int, host: str, token: str, folder: Path) -> None:
        self.number, self.host = number, host
        self._address = SiteAddress.parse(f"site://{host}/arm?stay")
        self._token, self._authority = token, folder / "tls.crt"
        self.session: RemoteRuntime | None = None
        self.results: list[event.Result] = []

    def listen(self, seconds: float) -> None:
        """Hear it for so long, and let it hear us; one that is gone is silent."""
        until = monotonic() + seconds
        while monotonic() < until:
            with suppress(LinkLost, TimeoutError):
                if self.session is not None:
                    self.results += [m for m in self.session.events(0.02) if isinstance(m, event.Result)]
                    continue
            sleep(0.02)

    def join(self) -> RemoteRuntime:
        """Have it run, and a session with it."""
        for again in (True, True, False):
            try:
                self.session = self.session or self._joined()
                return self.session
            except LinkLost as lost:  # as a person would, who is told why, try again
                print(f"    site{self.number}: {lost}", flush=True)
                if not again:
                    raise
        raise AssertionError

    def _joined(self) -> RemoteRuntime:
        handed = SiteClient(self._address, self._token, self._authority).launch()
        opening = WebSocketOpening(self._address.runtime(handed.port), self._token, self._authority)
        return RemoteRuntime(opening).__enter__()

    def leave(self) -> None:
        """It is gone, or to be begun anew."""
        if self.session is not None:
            with suppress(LinkLost, OSError, TimeoutError):
                self.session.__exit__(None, None, None)
        self.session = None

    def pid(self) -> int:
        """The process of the runtime's program."""
        wanted = [b"onika.host", f"{self.host}:7996".encode()]
        for path in Path("/proc").glob("[0-9]*/cmdline"):
            with suppress(OSError):
                words = path.read_bytes().split(b"\0")
                if all(word in words for word in wanted) and b"--link-fd" in words:
                    return int(path.parent.name)
        return 0
