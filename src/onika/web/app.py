"""The web application: the page, its files, and one WebSocket for each browser."""

import asyncio
from collections.abc import Sequence
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import FileResponse, RedirectResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.types import Message
from starlette.websockets import WebSocket

from onika.store.mesh_folder import MeshFolder
from onika.web.access.entrance import Entrance, Visitor
from onika.web.access.sign_in import SignIn
from onika.web.headers import StrictHeaders
from onika.web.login import Login
from onika.web.mesh_route import mesh_route
from onika.web.pace import Pace
from onika.web.packed_files import PackedFiles
from onika.web.refused_request import refused
from onika.web.sign_in_routes import asked
from onika.words.reason import Reason

if TYPE_CHECKING:  # loads the environment, for which a page that is asked for does not wait
    from onika.web.hub import Hub

STATIC = Path(__file__).parent / "static"
"""The page as it was built."""
PLAYER = STATIC / "player"
"""The player of shared files, beside it."""

_NOT_ALLOWED = 1008


def application(
    entrance: Entrance,
    hub: "asyncio.Future[Hub]",
    static: Path = STATIC,
    meshes: MeshFolder | None = None,
    ways: Sequence[Route] = (),
) -> Starlette:
    """The application; nothing but a refusal is told to whoever was not let in. Worlds are drawn of `meshes`.

    hub     what a browser waits for once it has the page
    ways    what else its door has
    """

    async def page(request: Request) -> Response:
        if not entrance.is_ours(request.headers):
            return refused(request, Reason.of("desk.no_such_host"), 421)
        if isinstance(entrance, Login) and "key" in request.query_params:
            return _by_key(request, entrance)
        if entrance.visitor(request.cookies) is None:
            if isinstance(entrance, SignIn):
                return asked(request)
            return refused(request, entrance.closed, 403)
        index = static / "index.html"
        if index.is_file():
            return FileResponse(index)
        return refused(request, Reason.of("desk.page_not_built"), 503)

    async def talk(socket: WebSocket) -> None:
        visitor = entrance.visitor(socket.cookies) if entrance.is_own_page(socket.headers) else None
        if visitor is None:
            await socket.close(_NOT_ALLOWED)
            return
        await socket.accept()
        await _converse(socket, hub, visitor)

    routes: list[Route | Mount | WebSocketRoute] = [Route("/", page), WebSocketRoute("/ws", talk)]
    routes += [mesh_route(entrance, meshes), *ways]
    if (static / "assets").is_dir():
        routes.append(Mount("/assets", PackedFiles(directory=static / "assets")))
    return Starlette(
        routes=routes,
        middleware=[Middleware(StrictHeaders)],
        exception_handlers={404: _nothing_there, 405: _only_read},
    )


def _by_key(request: Request, login: Login) -> Response:
    """The page for whoever has the key of this machine, and the way back for whoever was let in before."""
    if login.visitor(request.cookies) is not None:
        return RedirectResponse("/", 303)
    cookie = login.enter(request.query_params["key"])
    if cookie is None:
        return refused(request, Reason.of("desk.page_without_key"), 403)
    response = RedirectResponse("/", 303)
    response.set_cookie(login.cookie_name, cookie, httponly=True, samesite="strict", path="/")
    return response


async def _converse(socket: WebSocket, coming: "asyncio.Future[Hub]", visitor: Visitor) -> None:
    """Until the browser leaves, or its session ends; what it sends that is no act is refused like any other."""
    heard = asyncio.create_task(socket.receive())
    await asyncio.wait((coming, heard), return_when=asyncio.FIRST_COMPLETED)
    if heard.done() and _has_left(heard.result()):
        return
    await asyncio.wait((coming,))
    hub = coming.result()
    client = hub.come(visitor)
    pace = Pace()

    async def send() -> None:
        while True:
            await socket.send_text((await client.outbox.next()).decode())

    async def take() -> None:
        message = await heard
        while not _has_left(message):
            hub.take(client, message.get("text") or message.get("bytes") or "")
            await asyncio.sleep(pace.wait_s(monotonic()))
            message = await socket.receive()

    taking, sending = asyncio.create_task(take()), asyncio.create_task(send())
    ending = asyncio.create_task(client.ended.wait())
    try:
        await asyncio.wait((taking, ending), return_when=asyncio.FIRST_COMPLETED)
        if not taking.done():
            await socket.close(_NOT_ALLOWED)
    finally:
        for part in (taking, sending, ending):
            part.cancel()
        hub.leave(client)
    if taking.done():
        taking.result()


def _has_left(message: Message) -> bool:
    return str(message["type"]) == "websocket.disconnect"


async def _nothing_there(request: Request, _exception: Exception) -> Response:
    return refused(request, Reason.of("desk.no_such_page"), 404)


async def _only_read(request: Request, _exception: Exception) -> Response:
    return refused(request, Reason.of("desk.only_read"), 405)
