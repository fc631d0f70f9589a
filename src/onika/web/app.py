"""The web application: the page, its files, and one WebSocket for each browser."""

import asyncio
from pathlib import Path

from starlette.applications import Starlette
from starlette.middleware import Middleware
from starlette.requests import Request
from starlette.responses import FileResponse, PlainTextResponse, RedirectResponse, Response
from starlette.routing import Mount, Route, WebSocketRoute
from starlette.staticfiles import StaticFiles
from starlette.websockets import WebSocket

from onika.link import refusal_header
from onika.store.mesh_folder import MeshFolder
from onika.web.headers import StrictHeaders
from onika.web.hub import Hub
from onika.web.login import Login
from onika.web.mesh_route import mesh_route
from onika.words.accepted_language import accepted_language
from onika.words.reason import Reason, in_language

STATIC = Path(__file__).parent / "static"
"""The page as it was built."""

_NOT_ALLOWED = 1008


def application(login: Login, hub: Hub, static: Path = STATIC, meshes: MeshFolder | None = None) -> Starlette:
    """The application; nothing but a refusal is told to whoever has no key. Worlds are drawn of `meshes`."""

    async def page(request: Request) -> Response:
        if not login.is_ours(request.headers):
            return _refused(request, Reason.of("desk.no_such_host"), 421)
        key = request.query_params.get("key")
        if key is not None and not login.knows(request.cookies):
            cookie = login.enter(key)
            if cookie is None:
                return _refused(request, Reason.of("desk.page_without_key"), 403)
            return _with_cookie(RedirectResponse("/", 303), login.cookie_name, cookie)
        if key is not None:
            return RedirectResponse("/", 303)
        if not login.knows(request.cookies):
            return _refused(request, Reason.of("desk.page_without_key"), 403)
        index = static / "index.html"
        if index.is_file():
            return FileResponse(index)
        return _refused(request, Reason.of("desk.page_not_built"), 503)

    async def talk(socket: WebSocket) -> None:
        if not (login.is_own_page(socket.headers) and login.knows(socket.cookies)):
            await socket.close(_NOT_ALLOWED)
            return
        await socket.accept()
        await _converse(socket, hub)

    routes: list[Route | Mount | WebSocketRoute] = [Route("/", page), WebSocketRoute("/ws", talk)]
    routes.append(mesh_route(login, meshes, _refused))
    if (static / "assets").is_dir():
        routes.append(Mount("/assets", StaticFiles(directory=static / "assets")))
    return Starlette(
        routes=routes,
        middleware=[Middleware(StrictHeaders)],
        exception_handlers={404: _nothing_there, 405: _only_read},
    )


async def _converse(socket: WebSocket, hub: Hub) -> None:
    """Until the browser leaves; what it sends that is no act is refused like any other."""
    client = hub.come()

    async def send() -> None:
        while True:
            await socket.send_text((await client.outbox.next()).decode())

    sending = asyncio.create_task(send())
    try:
        while (message := await socket.receive())["type"] != "websocket.disconnect":
            hub.take(client, message.get("text") or message.get("bytes") or "")
    finally:
        sending.cancel()
        hub.leave(client)


async def _nothing_there(request: Request, _exception: Exception) -> Response:
    return _refused(request, Reason.of("desk.no_such_page"), 404)


async def _only_read(request: Request, _exception: Exception) -> Response:
    return _refused(request, Reason.of("desk.only_read"), 405)


def _refused(request: Request, reason: Reason, code: int) -> Response:
    """The sentence in the language of ours that the browser likes best, and the reason in a header for programs."""
    language = accepted_language(",".join(request.headers.getlist("accept-language")))
    headers = {"content-language": language, refusal_header.HEADER: refusal_header.written(reason)}
    return PlainTextResponse(f"{in_language(reason, language)}\n", code, headers)


def _with_cookie(response: Response, name: str, cookie: str) -> Response:
    response.set_cookie(name, cookie, httponly=True, samesite="strict", path="/")
    return response
