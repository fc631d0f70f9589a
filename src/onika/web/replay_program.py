"""A session that is replayed in the page: its environment, its log and browsers in one loop (requirement H08)."""

import asyncio
import socket
from collections.abc import Callable

from onika.desk.environment.replay import replay_control
from onika.desk.environment.replay.replay_control import ReplayControl
from onika.desk.environment.replay.session_player import SessionPlayer
from onika.store.mesh_folder import MeshFolder
from onika.web.access.entrance import Visitor
from onika.web.hub import Hub
from onika.web.page_door import KeyDoor
from onika.web.served_door import ServedDoor
from onika.wire import act, page
from onika.words.reason import Reason

_TURN_S = 0.02
"""Between two looks at what is due."""


class NoValues:
    """The values of a replay: there are none, a log has no readings."""

    def watch(self, variables: frozenset[str], worlds: frozenset[str], figures: bool, hz: float) -> None:
        """Nothing can be watched."""

    def frame(self) -> page.Frame | None:
        """Nothing has come."""
        return None


class ReplayProgram:
    """One replay, from its beginning until Ctrl-C; whoever comes watches and steers it, and changes nothing."""

    def __init__(self, player: SessionPlayer, control: ReplayControl) -> None:
        self._player = player
        self._control = control

    async def run(self, listening: socket.socket, on_ready: Callable[[str], None]) -> None:
        """Until Ctrl-C; `on_ready` is told each address that lets one browser in."""
        hub = Hub(self._player.environment, NoValues(), may=_refusal)
        hub.remember(self._player.says)
        self._control.begin(self._player)
        meshes = MeshFolder(self._player.place.state)
        opened = ServedDoor(KeyDoor(listening, on_ready), hub, listening, meshes)
        try:
            await opened.serve((self._play(),))
        finally:
            opened.close()

    async def _play(self) -> None:
        """Carry out what is due."""
        while True:
            await asyncio.sleep(0 if self._control.advance() else _TURN_S)


def _refusal(_visitor: Visitor, command: act.AnyAct) -> Reason:
    return replay_control.refusal(command)
