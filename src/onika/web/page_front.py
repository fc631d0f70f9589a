"""The page of this machine, served before its environment is there."""

import asyncio
import socket
from collections.abc import Callable, Coroutine, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self

from onika.store.mesh_folder import MeshFolder
from onika.web.app import application
from onika.web.page_door import KeyDoor
from onika.web.server import serve, until_first_ends

if TYPE_CHECKING:  # what is to be loaded later
    from onika.desk.environment.environment import Environment
    from onika.web.hub import Hub
    from onika.web.program import EnvironmentProgram


class PageFront:
    """Gives browsers the page while the environment is loaded: they take their time for it, and wait for the hub then.

    on_ready    told of each address that lets one browser in
    state       where meshes are kept
    """

    def __init__(self, listening: socket.socket, on_ready: Callable[[str], None], state: Path) -> None:
        self._listening = listening
        self._on_ready = on_ready
        self._state = state
        self._hub: asyncio.Future[Hub]

    async def run(self, load: "Callable[[], EnvironmentProgram]") -> None:
        """Until Ctrl-C. `load` makes the environment, in a thread: nobody who asks for the page waits for it."""
        self._hub = asyncio.get_running_loop().create_future()
        door = KeyDoor(self._listening, self._on_ready)
        app = application(door.entrance, self._hub, meshes=MeshFolder(self._state))
        try:
            await serve(app, self._listening, (self._live(load),), door.ready)
        finally:
            self._listening.close()
            door.close()

    def open(self, _environment: "Environment", hub: "Hub") -> Self:
        """The environment is there: whoever has come meets it."""
        self._hub.set_result(hub)
        return self

    async def serve(self, beside: Iterable[Coroutine[Any, Any, object]]) -> None:
        """Until one of what runs beside ends; the page is served already."""
        await until_first_ends(beside)

    def close(self) -> None:
        """The environment has ended, and with it what serves the page."""

    async def _live(self, load: "Callable[[], EnvironmentProgram]") -> None:
        program = await asyncio.to_thread(load)
        await program.run(self.open)
