"""The site as a program: it listens, launches, and ends all that it has launched when it ends (requirement A15)."""

import asyncio
from collections.abc import Callable
from dataclasses import dataclass
from datetime import UTC, date, datetime
from pathlib import Path
from time import monotonic_ns, time

import uvicorn
from starlette.applications import Starlette

from onika.agent.attended_runtime import AttendedRuntime
from onika.agent.booked_robots import BookedRobots
from onika.agent.change_check import ChangeCheck
from onika.agent.door import application
from onika.agent.launches import SiteLaunches
from onika.agent.library_keeper import LibraryKeeper
from onika.agent.site_state import SiteState
from onika.booking.book import BookingBook
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.host.sessions.admission import Admission
from onika.host.sessions.listen_options import ListenerSettings, context
from onika.host.sessions.listener_main import listen
from onika.host.sessions.site_clock import SiteClock
from onika.host.sessions.users import Users
from onika.link.address import bracketed
from onika.model.launch import Launch
from onika.store.audit_trail import AuditTrail
from onika.store.remote.publication import Publisher
from onika.store.site import open_site
from onika.web.connection_limit import limited_protocol
from onika.words.reason import Reason


@dataclass(frozen=True, slots=True)
class SiteOptions:
    """What the command line asks for.

    users       the file of users, which the runtimes get, too
    book        the file of bookings
    library     what is published of the site's own, and may be changed by who brings code; None: nothing
    """

    name: str
    launches: tuple[Launch, ...]
    users: str
    book: Path
    with_fifo: bool = True
    has_black_box: bool = True
    library: Publisher | None = None


class SiteProgram:
    """A site that listens where its settings say; raises OSError where it cannot, or is served already."""

    def __init__(self, options: SiteOptions, settings: ListenerSettings, state: Path) -> None:
        self._options = options
        self._settings = settings
        self._state = SiteState(state, options.name)
        try:
            book = BookedRobots(BookingBook(options.book), SiteClock(time, monotonic_ns))
            self._library = self._kept(options.library, state)
            self._listening = listen(settings.host, settings.port)
        except BaseException:
            self._state.close()
            raise
        self._launches = SiteLaunches(options.name, self._state.identity, options.launches, self._begun, book)

    @property
    def place(self) -> str:
        """Host and port at which it listens."""
        return f"{bracketed(self._settings.host)}:{self._listening.getsockname()[1]}"

    def run(self, on_ready: Callable[[str], None]) -> None:
        """Serve until Ctrl-C or SIGTERM; then all that it has launched ends, and drives hold."""
        try:
            admission = Admission(Users(self._settings.users), self._settings.names, bool(self._settings.certificate))
            asyncio.run(self._serve(application(admission, self._launches, library=self._library), on_ready))
        finally:
            self._launches.close()
            self._state.close()

    async def _serve(self, app: Starlette, on_ready: Callable[[str], None]) -> None:
        config = uvicorn.Config(
            app,
            log_level="warning",
            access_log=False,
            lifespan="off",
            http=limited_protocol(),
            ws="none",
            timeout_graceful_shutdown=1,
            server_header=False,
        )
        config.load()
        if self._settings.certificate:
            config.ssl = context(self._settings.certificate, self._settings.key)
        server = uvicorn.Server(config)
        serving = asyncio.ensure_future(server.serve(sockets=[self._listening]))
        while not server.started and not serving.done():
            await asyncio.sleep(0.005)
        on_ready(self.place)
        await serving

    def _kept(self, library: Publisher | None, state: Path) -> LibraryKeeper | None:
        """The library of the site, published; raises OSError where that is not possible."""
        if library is None:
            return None
        types, faults = open_site([library.base], {}, state).syntax()
        if types is None:
            raise OSError(faults[0].sentence)
        trail = AuditTrail(trail_path(state, library.name))
        keeper = LibraryKeeper(library, ChangeCheck(types), trail, _today, monotonic_ns)
        published = keeper.begin()
        if isinstance(published, Reason):
            trail.close()
            raise OSError(Reason.of("site.library_not_kept", library=library.name, why=published))
        return keeper

    def _begun(self, launch: Launch, stays: bool) -> AttendedRuntime:
        return AttendedRuntime(lambda: self._launched(launch), stays=stays)

    def _launched(self, launch: Launch) -> LaunchedRuntime:
        options = self._options
        return LaunchedRuntime(
            launch.units,
            launch.is_virtual,
            options.with_fifo and not launch.is_virtual,
            self._words(launch),
            options.has_black_box,
        )

    def _words(self, launch: Launch) -> list[str]:
        """What the runtime program is told beside its units: where it listens, for whom, and what it may do."""
        settings = self._settings
        words = ["--listen", f"{bracketed(settings.host)}:{launch.port}"]
        named = {"--cert": settings.certificate, "--key": settings.key, "--users": self._options.users}
        words += [word for option, value in named.items() if value for word in (option, value)]
        words += [word for name in settings.names for word in ("--name", name)]
        words += [word for world in launch.worlds for word in ("--world", world)]
        words += ["--accept-code"] * launch.takes_code
        words += ["--lease", f"{launch.lease_s:g}"] if launch.lease_s else []
        if launch.robot:
            words += ["--robot", launch.robot, "--book", str(self._options.book)]
            words += ["--require-booking"] * launch.needs_booking
        return words


def trail_path(state: Path, library: str) -> Path:
    """Where it stands who has changed a library of this site."""
    return state / "audit" / f"library-{library}.log"


def _today() -> date:
    return datetime.now(UTC).date()
