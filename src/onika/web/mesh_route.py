"""Meshes of worlds for the page that draws them: `/mesh/NAME`, for whoever was let in, kept for ever by its name."""

import asyncio
import gzip

from starlette.requests import Request
from starlette.responses import Response
from starlette.routing import Route

from onika.store.mesh_folder import MeshFolder
from onika.web.access.entrance import Entrance
from onika.web.refused_request import refused
from onika.words.reason import Reason

_BYTES = "application/octet-stream"


def mesh_route(entrance: Entrance, meshes: MeshFolder | None) -> Route:
    """The way to the meshes; without a folder there are none."""

    async def mesh(request: Request) -> Response:
        if not entrance.is_ours(request.headers):
            return refused(request, Reason.of("desk.no_such_host"), 421)
        if entrance.visitor(request.cookies) is None:
            return refused(request, Reason.of("desk.page_without_key"), 403)
        name = request.path_params["name"]
        packed = await asyncio.to_thread(meshes.packed, name) if meshes is not None else None
        if packed is None:
            return refused(request, Reason.of("desk.no_such_page"), 404)
        return _answer(packed, takes_gzip="gzip" in request.headers.get("accept-encoding", ""))

    return Route("/mesh/{name}", mesh)


def _answer(packed: bytes, *, takes_gzip: bool) -> Response:
    """As gzip packs them, or as they were for whoever does not take that."""
    headers = {"vary": "accept-encoding"}
    if takes_gzip:
        return Response(packed, 200, {**headers, "content-encoding": "gzip"}, _BYTES)
    return Response(gzip.decompress(packed), 200, headers, _BYTES)
