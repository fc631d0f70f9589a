"""The door of a page that is served to others: users, sessions and the trail of what they do, as one (F10)."""

import asyncio
import os
import socket
import ssl
from collections.abc import Callable
from functools import partial

from onika.desk.environment.environment import ActAnswer, Environment
from onika.files.trail import usual_path
from onika.store.audit_trail import open_free
from onika.web.access.page_place import PagePlace
from onika.web.access.page_trail import PageTrail
from onika.web.access.page_users import PageUserFile
from onika.web.access.sign_in import SignIn
from onika.web.hub import Hub
from onika.web.sign_in_routes import sign_in_routes
from onika.wire import act, page
from onika.words.reason import NOTHING, Reason

_LOOK_S = 1.0
"""Between two looks at who is still a user."""
TRAIL = "page.log"
"""Beside the audit trails of runtimes."""


class GuardedDoor:
    """Lets in the users of a place; raises OSError where nothing can be written down of what they do."""

    def __init__(
        self,
        place: PagePlace,
        listening: socket.socket,
        on_ready: Callable[[str], None],
        environment: Environment,
        hub: Hub,
    ) -> None:
        self._place = place
        self._on_ready = on_ready
        self._port: int = listening.getsockname()[1]
        self._hub = hub
        self._audit = open_free(usual_path(os.environ).with_name(TRAIL))
        self._trail = PageTrail(self._audit, _complaint(environment))
        users = PageUserFile(place.users)
        users.look()
        self.entrance = SignIn(place.names, self._port, users, self._trail)
        self.ways = sign_in_routes(self.entrance, hub.end)
        hub.denials.append(self._trail.denied)
        environment.observers.append(lambda command, by: partial(self._acted, command, by))

    @property
    def context(self) -> ssl.SSLContext:
        """The server's side of TLS."""
        return self._place.context

    def ready(self) -> None:
        """Tell where it is."""
        self._audit.note("PageOpened", True, about=f"{self._place.host}:{self._port}")
        self._on_ready(self._place.address(self._port))

    async def keep(self) -> None:
        """End what is over, again and again, with the pages of it."""
        while True:
            await asyncio.sleep(_LOOK_S)
            for session in self.entrance.sweep(self._hub.sessions):
                self._hub.end(session)

    def close(self) -> None:
        """Let in nobody any more."""
        self.entrance.close()
        self._audit.close()

    def _acted(self, command: act.AnyAct, by: str, given: ActAnswer) -> None:
        visitor = self._hub.visitor(by)
        if visitor is not None:
            self._trail.acted(visitor, command, NOTHING if given.no is None else given.no.reason)


def _complaint(environment: Environment) -> Callable[[Reason], None]:
    def complain(why: Reason) -> None:
        environment.say(page.Say("error", Reason.of("desk.page_trail_unwritable", why=why)))

    return complain
