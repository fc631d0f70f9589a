"""The door of a site: HTTP for who has a token of it, and three verbs: look, launch, end (requirement A15).

No request of these carries a command, a path or code; a body is not read. Where the site keeps a library, changed files
of it come in by `library_door`.
"""

import asyncio
from collections.abc import Callable
from functools import partial
from time import monotonic_ns

from msgspec import json
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from onika.agent import library_door
from onika.agent.launches import Guest, SiteLaunches, SiteRefusal
from onika.agent.library_keeper import LibraryKeeper
from onika.host.sessions.admission import Admission, TurnedAway
from onika.web.refused_request import refused
from onika.words.reason import Reason

_AT_A_TIME = 4
"""Launches and ends that are carried out at a time; others wait their turn."""


def application(
    admission: Admission,
    launches: SiteLaunches,
    clock: Callable[[], int] = monotonic_ns,
    library: LibraryKeeper | None = None,
) -> Starlette:
    """The application; `clock` is ns that never go back."""
    turns = asyncio.Semaphore(_AT_A_TIME)

    admits = partial(_admitted, admission, clock)

    async def answered(request: Request, do: Callable[[Guest], object]) -> Response:
        """What is done for whoever is let in, or why it is not."""
        asks = admits(request)
        if isinstance(asks, Response):
            return asks
        try:
            async with turns:
                answer = await asyncio.to_thread(do, asks)
        except SiteRefusal as refusal:
            return refused(request, refusal.reason, refusal.status)
        return _json(answer)

    async def card(request: Request) -> Response:
        asks = admits(request)
        return asks if isinstance(asks, Response) else _json(await asyncio.to_thread(launches.card, asks))

    async def launch(request: Request) -> Response:
        name, stays = request.path_params["name"], "stay" in request.query_params
        return await answered(request, lambda asks: launches.launch(name, asks, stays=stays))

    async def end(request: Request) -> Response:
        name = request.path_params["name"]
        return await answered(request, lambda asks: launches.end(name, asks))

    async def nothing_there(request: Request, _exception: Exception) -> Response:
        return refused(request, Reason.of("site.no_such_path"), 404)

    async def other_verb(request: Request, _exception: Exception) -> Response:
        return refused(request, Reason.of("site.no_such_path"), 405)

    routes = [
        Route("/card", card, methods=["GET"]),
        Route("/launch/{name}", launch, methods=["POST"]),
        Route("/end/{name}", end, methods=["POST"]),
    ]
    if library is not None:
        routes += library_door.routes(library, admits)
    return Starlette(routes=routes, exception_handlers={404: nothing_there, 405: other_verb})


def _admitted(admission: Admission, clock: Callable[[], int], request: Request) -> Guest | Response:
    """Who asks, or the answer to somebody who is not let in."""
    address = request.client.host if request.client is not None else ""
    user = admission.user(request.headers.items(), address, clock())
    if isinstance(user, TurnedAway):
        return refused(request, user.reason, user.status)
    return Guest(user.name, user.role)


def _json(answer: object) -> Response:
    return Response(json.encode(answer), 200, {"cache-control": "no-store"}, "application/json")
