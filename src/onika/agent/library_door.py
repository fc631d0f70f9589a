"""The door of a site's library: whoever has a token reads it; who may bring code sends changed files (F03)."""

import asyncio
import re
from collections.abc import Awaitable, Callable
from hashlib import sha256

from msgspec import DecodeError, ValidationError, json
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response
from starlette.routing import Route

from onika.agent.launches import Guest
from onika.agent.library_keeper import MOST_BYTES, LibraryKeeper
from onika.store.remote.object_cache import is_digest
from onika.store.remote.source import INDEX, OBJECTS, object_path
from onika.web.refused_request import refused
from onika.wire.library_change import ChangeAnswer, ChangedMeanwhile, ChangeRefused, LibraryChange
from onika.words.reason import Reason

LARGEST = 2 * MOST_BYTES
"""Bytes of a request: what it holds is written in letters."""
_BYTES = "application/octet-stream"
_PATIENCE_S = 60.0
_AT_A_TIME = 3
"""Changes that are heard at a time; others wait their turn."""
_SPAN = re.compile(r"bytes=([0-9]{1,12})-([0-9]{1,12})\Z")
"""What is asked for of a long file over one of several connections; whatever else is asked for is the whole file."""
_STATUS = {ChangedMeanwhile: 409, ChangeRefused: 403}

Admits = Callable[[Request], Guest | Response]
"""Who asks, or the answer to somebody who is not let in."""


def routes(keeper: LibraryKeeper, admits: Admits) -> list[Route]:
    """What is answered below `/library`."""
    turns = asyncio.Semaphore(_AT_A_TIME)

    async def index(request: Request) -> Response:
        return await _file(request, admits(request), keeper, INDEX)

    async def found(request: Request) -> Response:
        digest = request.path_params["digest"]
        path = object_path(digest) if is_digest(digest) else ""
        return await _file(request, admits(request), keeper, path)

    async def changed(request: Request) -> Response:
        guest = admits(request)
        if isinstance(guest, Response):
            return guest
        async with turns:
            change = await _within(request, _change(request))
            if isinstance(change, Response):
                return change
            return _answer(await asyncio.to_thread(keeper.take, change, guest))

    return [
        Route(f"/library/{INDEX}", index, methods=["GET"]),
        Route(f"/library/{OBJECTS}/{{digest}}", found, methods=["GET"]),
        Route("/library/changes", changed, methods=["POST"]),
    ]


async def _file(request: Request, guest: Guest | Response, keeper: LibraryKeeper, path: str) -> Response:
    if isinstance(guest, Response):
        return guest
    file = keeper.publisher.folder / path
    try:
        content = await asyncio.to_thread(file.read_bytes)
    except OSError:
        return refused(request, Reason.of("site.no_such_file"), 404)
    headers = {"cache-control": "no-store", "etag": f'"{sha256(content).hexdigest()}"'}
    span = _SPAN.match(request.headers.get("range", ""))
    if span is None:
        return Response(content, 200, headers, _BYTES)
    begin, end, size = int(span[1]), min(int(span[2]) + 1, len(content)), len(content)
    if begin >= end:
        return Response(status_code=416, headers={"content-range": f"bytes */{size}"})
    return Response(content[begin:end], 206, {**headers, "content-range": f"bytes {begin}-{end - 1}/{size}"}, _BYTES)


async def _within(request: Request, change: Awaitable[LibraryChange | Response]) -> LibraryChange | Response:
    try:
        async with asyncio.timeout(_PATIENCE_S):
            return await change
    except TimeoutError:
        return refused(request, Reason.of("site.change_slow", seconds=_PATIENCE_S), 408)
    except ClientDisconnect:
        return Response(status_code=400)


async def _change(request: Request) -> LibraryChange | Response:
    """What is sent, as far as it is allowed to be long."""
    large = refused(request, Reason.of("site.change_large", size=LARGEST, most=MOST_BYTES), 413)
    length = request.headers.get("content-length", "")
    if length.isdecimal() and int(length) > LARGEST:
        return large
    body = bytearray()
    async for part in request.stream():
        body += part
        if len(body) > LARGEST:
            return large
    try:
        return json.decode(body, type=LibraryChange)
    except (DecodeError, ValidationError, RecursionError):
        return refused(request, Reason.of("site.no_change"), 400)


def _answer(answer: ChangeAnswer) -> Response:
    headers = {"cache-control": "no-store"}
    return Response(json.encode(answer), _STATUS.get(type(answer), 200), headers, "application/json")
