"""The process of a seat: an environment of its own, confined to the seat's folder, with limits of its own (X25).

It is forked from a server that has loaded the environment already, so that twenty of them start soon and share what
they do not change.
"""

import asyncio
import ctypes
import os
import resource
import socket
import sys
import sysconfig
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from onika.classroom import messages
from onika.classroom.seat_door import Channel, SeatDoor
from onika.classroom.seat_entrance import SeatEntrance
from onika.classroom.seat_rights import SeatRights
from onika.desk.environment.environment import Environment
from onika.files.state.state_directory import make_own, state_directory
from onika.process import confinement
from onika.store.mesh_folder import MeshFolder
from onika.store.shipped import shipped
from onika.store.site import OWN, open_site
from onika.web.access.certificate import server_context
from onika.web.environment_options import EnvironmentOptions
from onika.web.hub import Hub
from onika.web.program import EnvironmentProgram
from onika.web.served_door import ServedDoor

NICE = 5
"""The class itself comes before its seats."""
_FILES, _LARGEST_FILE = 1024, 256 << 20
_KEPT = ("PATH", "LANG", "LC_ALL", "LC_CTYPE", "LC_MESSAGES", "TZ", "MUJOCO_GL", "OMP_NUM_THREADS")
"""What a seat knows of the surroundings of its class."""
_SYSTEM = ("/usr", "/bin", "/lib", "/lib64", "/etc", "/proc", "/sys/devices/system/cpu", "/dev/urandom", "/opt", "/nix")
_DEVICES = ("/dev/null", "/dev/zero", "/dev/shm")  # noqa: S108 - shared memory
_UNDUMPABLE = 4  # PR_SET_DUMPABLE of prctl(2)


@dataclass(frozen=True, slots=True)
class SeatSettings:
    """What a seat is to be.

    folder          its own; nothing else is written
    names           under which this machine is called
    files           what is opened at first
    materials       base directories of the teacher, which are read
    certificate     with `key`: its page is served over TLS; empty: over HTTP
    is_confined     whether the kernel is asked to keep it in its folder
    """

    number: int
    learner: str
    folder: Path
    names: tuple[str, ...]
    files: tuple[str, ...] = ()
    materials: tuple[Path, ...] = ()
    certificate: str = ""
    key: str = ""
    is_confined: bool = True
    may_write_code: bool = False
    is_upper_only: bool = False


def keep_seat(settings: SeatSettings, listening: socket.socket, channel: socket.socket) -> None:
    """Be a seat until its class says otherwise, or is gone."""
    os.setsid()
    _step_back()
    _settle(settings)
    context = server_context(settings.certificate, settings.key) if settings.certificate else None
    if settings.is_confined:
        confinement.confine(readable(settings.materials), (settings.folder, *map(Path, _DEVICES)))
    site = open_site(settings.materials, os.environ, Path(os.environ["HOME"]))
    options = EnvironmentOptions(
        settings.files,
        is_connected=False,  # a runtime is started when something is to be run
        is_virtual=True,
        with_fifo=False,
        foresees=False,  # each forecast would be one more runtime
        is_upper_only=settings.is_upper_only,
        may_repose=True,
    )
    state = state_directory(os.environ)
    program = EnvironmentProgram(site, options, state)
    entrance = SeatEntrance(settings.names, listening.getsockname()[1], settings.learner, is_secure=context is not None)
    rights = SeatRights(may_write_code=settings.may_write_code)
    own = Path(os.environ["HOME"]) / OWN

    def opens(environment: Environment, hub: Hub) -> ServedDoor:
        def joins() -> asyncio.Task[Channel]:
            joining = asyncio.open_connection(sock=channel, limit=messages.LONGEST)
            return asyncio.ensure_future(joining)

        door = SeatDoor(entrance, rights, settings.folder, own, environment, hub, joins, context)
        return ServedDoor(door, hub, listening, MeshFolder(state))

    asyncio.run(program.run(opens))


def readable(materials: tuple[Path, ...]) -> tuple[Path, ...]:
    """What a seat may read beside its own folder: the system, Python, Onika, what its teacher has put there."""
    python = (sys.prefix, sys.base_prefix, sysconfig.get_path("stdlib"), str(Path(sys.executable).resolve().parent))
    packages = (path for path in sys.path if Path(path).is_dir())
    onika = shipped().parent
    return (*map(Path, dict.fromkeys((*_SYSTEM, *python, *packages, str(onika)))), *materials)


def _settle(settings: SeatSettings) -> None:
    """In its own folder, with surroundings of its own, and what it prints in a file there."""
    folder = settings.folder
    home, temporary = folder / "home", folder / "tmp"
    for place in (folder, home, temporary, folder / "state", folder / "cache"):
        make_own(place)
    environment = {name: os.environ[name] for name in _KEPT if name in os.environ}
    environment |= {
        "HOME": str(home),
        "TMPDIR": str(temporary),
        "XDG_STATE_HOME": str(folder / "state"),
        "XDG_CACHE_HOME": str(folder / "cache"),
        "OPENBLAS_NUM_THREADS": "1",
    }
    os.environ.clear()
    os.environ.update(environment)
    os.chdir(folder)
    log = os.open(folder / "seat.log", os.O_WRONLY | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o600)
    for number in (1, 2):
        os.dup2(log, number)
    os.close(log)


def _step_back() -> None:
    """Limits of its own, and behind the class; nobody of the same user looks into its memory, where its key is."""
    os.nice(NICE)
    for path, word in _own_group():
        with suppress(OSError):
            path.write_text(word)
    for kind, wanted in ((resource.RLIMIT_NOFILE, _FILES), (resource.RLIMIT_FSIZE, _LARGEST_FILE)):
        _, hard = resource.getrlimit(kind)
        resource.setrlimit(kind, (wanted if hard < 0 else min(wanted, hard),) * 2)
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    ctypes.CDLL(None).prctl(_UNDUMPABLE, 0, 0, 0, 0)


def _own_group() -> Iterator[tuple[Path, str]]:
    """The kernel shares processors out by session first, where it is built so: then each seat has its share."""
    yield Path("/proc/self/autogroup"), str(NICE)
