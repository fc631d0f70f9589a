import asyncio
import contextlib
import threading

import pytest

from kit.desk.environment_fixture import EnvironmentFixture
from onika.model.task import Task
from onika.store.mesh_folder import MeshFolder
from onika.web.app import application
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
        self._app = application(self.login, self.hub, static, self.meshes)
        self._listening = listening
        self._ready = threading.Event()
        self._thread = threading.Thread(target=lambda: asyncio.run(self._run()))

    async def _run(self):
        self._loop = asyncio.get_running_loop()
        self._end = asyncio.Event()
        await serve(self._app, self._listening, [self._end.wait()], self._ready.set)

    def __enter__(self):
        self._thread.start()
        assert self._ready.wait(20)
        return self

    def __exit__(self, *_):
        with contextlib.suppress(RuntimeError):
            self._loop.call_soon_threadsafe(self._end.set)
        self._thread.join(20)


@pytest.fixture
def served(tmp_path):
    static = tmp_path / "static"
    (static / "assets").mkdir(parents=True)
    (static / "index.html").write_text("<title>Onika</title>")
    (static / "assets" / "page.js").write_text("1")
    with Served(tmp_path / "base", static) as served:
        yield served
