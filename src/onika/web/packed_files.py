"""The files of the page, packed for whoever takes them so: a third of the bytes, which counts from afar."""

from starlette.exceptions import HTTPException
from starlette.requests import Request
from starlette.responses import Response
from starlette.staticfiles import StaticFiles
from starlette.types import Scope

_PACKED = ".gz"


class PackedFiles(StaticFiles):
    """Files of a folder: who takes gzip gets `page.js.gz` in place of `page.js`, where that lies beside it."""

    async def get_response(self, path: str, scope: Scope) -> Response:
        """The file at `path`, packed or not. Raises HTTPException where there is none."""
        response = None
        if "gzip" in Request(scope).headers.get("accept-encoding", ""):
            response = await self._packed(path, scope)
        response = response or await super().get_response(path, scope)
        response.headers["vary"] = "accept-encoding"
        return response

    async def _packed(self, path: str, scope: Scope) -> Response | None:
        try:
            response = await super().get_response(path + _PACKED, scope)
        except HTTPException:
            return None
        response.headers["content-encoding"] = "gzip"
        return response
