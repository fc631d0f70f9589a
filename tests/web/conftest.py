import asyncio
import contextlib
import os
import shutil
import ssl
import subprocess
import threading
from pathlib import Path

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.files import trail
from onika.link.caller import Role
from onika.model.task import Task
from onika.store.mesh_folder import MeshFolder
from onika.web.access.certificate import server_context
from onika.web.access.page_place import PagePlace
from onika.web.access.page_users import PageUser, PageUserFile
from onika.web.access.password_hash import PasswordHash
from onika.web.app import application
from onika.web.guarded_door import TRAIL, GuardedDoor
from onika.web.hub import Hub
from onika.web.login import Login
from onika.web.server import addresses, bound, serve


class Nothing:
    def watch(self, variables, worlds, figures, hz):
        pass

    def frame(self):
        return None


class Served:
    """An environment that is served on a port of this machine."""

    def __init__(self, folder, static):
        self.sitting = EnvironmentFixture(folder, (Task("a", "a", outvar=("Q",), frequency=1.0),))
        listening = bound(0)
        self.address = addresses(listening)[0]
        self.login = Login(addresses(listening))
        self.hub = Hub(self.sitting.environment, Nothing())
        self.meshes = MeshFolder(folder / "state")
        self._static = static
        self._listening = listening
        self._context = None
        self._beside = ()
        self._ready = threading.Event()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._run()))

    def _application(self, hub):
        return application(self.login, hub, self._static, self.meshes)

    async def _run(self):
        self._loop = asyncio.get_running_loop()
        self._end = asyncio.Event()
        beside = [self._end.wait(), *(coroutine() for coroutine in self._beside)]
        hub = self._loop.create_future()
        hub.set_result(self.hub)
        await serve(self._application(hub), self._listening, beside, self._ready.set, self._context)

    def __enter__(self):
        self._thread.start()
        assert self._ready.wait(20)
        return self

    def __exit__(self, *_):
        with contextlib.suppress(RuntimeError):
            self._loop.call_soon_threadsafe(self._end.set)
        self._thread.join(20)


class ServedToOthers(Served):
    """The same over TLS, for users of each role; `file` is theirs."""

    def __init__(self, folder, static, certificate, users):
        super().__init__(folder, static)
        self.file = PageUserFile(folder / "users")
        for user in users:
            self.file.put(user)
        place = PagePlace("127.0.0.1", 0, server_context(*certificate), certificate[0], self.file.path, ("localhost",))
        self.door = GuardedDoor(place, self._listening, lambda _address: None, self.sitting.environment, self.hub)
        self._context, self._beside = place.context, (self.door.keep,)
        self.address = self.address.replace("127.0.0.1", "localhost")
        self.trusted = ssl.create_default_context(cafile=certificate[0])

    def _application(self, hub):
        return application(self.door.entrance, hub, self._static, self.meshes, self.door.ways)

    def trail(self):
        """What was written down: who did what, and what came of it."""
        path = Path(os.environ["XDG_STATE_HOME"]) / "onika" / "audit" / TRAIL
        records = trail.read([path]).records
        return [(record["what"], record.get("who"), record.get("result")) for record in records]

    def __exit__(self, *_):
        super().__exit__()
        self._listening.close()
        self.door.close()


@pytest.fixture(scope="module")
def served_to_others(tmp_path_factory, certificate, cheap_users):
    folder = tmp_path_factory.mktemp("others")
    static = folder / "static"
    (static / "assets").mkdir(parents=True)
    (static / "index.html").write_text("<title>Onika</title>")
    (static / "assets" / "page.js").write_text("1")
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(folder / "state"))
        with ServedToOthers(folder / "base", static, certificate, cheap_users) as served:
            yield served


@pytest.fixture
def served(tmp_path):
    static = tmp_path / "static"
    (static / "assets").mkdir(parents=True)
    (static / "index.html").write_text("<title>Onika</title>")
    (static / "assets" / "page.js").write_text("1")
    with Served(tmp_path / "base", static) as served:
        yield served


PASSWORD = "correct horse battery"


@pytest.fixture(scope="session")
def certificate(tmp_path_factory):
    """A certificate for localhost and its key, as files."""
    if shutil.which("openssl") is None:
        pytest.skip("there is no openssl to make a certificate with")
    folder = tmp_path_factory.mktemp("certificate")
    files = folder / "cert.pem", folder / "key.pem"
    kind = ["-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes", "-days", "2"]
    names = ["-subj", "/CN=localhost", "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1"]
    words = ["openssl", "req", "-x509", *kind, *names, "-out", str(files[0]), "-keyout", str(files[1])]
    subprocess.run(words, check=True, capture_output=True)
    files[1].chmod(0o600)
    return tuple(map(str, files))


@pytest.fixture(scope="session")
def cheap_users():
    """A user of each role, all with one password that costs a third of the usual."""
    kept = PasswordHash.of(PASSWORD, lanes=1)
    return tuple(PageUser(role.word[:3], role, kept) for role in Role)
