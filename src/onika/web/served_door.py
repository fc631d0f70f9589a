"""The page behind a door that was made for its environment: users sign in there, or a class sends them."""

import asyncio
import socket
from collections.abc import Coroutine, Iterable
from typing import Any

from onika.store.mesh_folder import MeshFolder
from onika.web.app import application
from onika.web.hub import Hub
from onika.web.page_door import PageDoor
from onika.web.server import serve


class ServedDoor:
    """The page on a socket, for whoever its door lets in; worlds are drawn of `meshes`."""

    def __init__(self, door: PageDoor, hub: Hub, listening: socket.socket, meshes: MeshFolder) -> None:
        self._door = door
        self._hub = hub
        self._listening = listening
        self._meshes = meshes

    async def serve(self, beside: Iterable[Coroutine[Any, Any, object]]) -> None:
        """Until Ctrl-C, or until one of what runs beside ends."""
        door, hub = self._door, asyncio.get_running_loop().create_future()
        hub.set_result(self._hub)
        app = application(door.entrance, hub, meshes=self._meshes, ways=door.ways)
        await serve(app, self._listening, (*beside, door.keep()), door.ready, door.context)

    def close(self) -> None:
        """Let nobody in any more."""
        self._listening.close()
        self._door.close()
