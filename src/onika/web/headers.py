"""The HTTP headers of every answer: nothing from elsewhere is loaded, embedded or guessed."""

from starlette.datastructures import MutableHeaders
from starlette.types import ASGIApp, Message, Receive, Scope, Send

_POLICY = "; ".join(
    (
        "default-src 'none'",
        "script-src 'self'",
        "style-src 'self' 'unsafe-inline'",  # positions and colours are set on elements
        "img-src 'self' data: blob:",
        "font-src 'self'",
        "connect-src 'self' ws: wss:",  # older browsers do not count a WebSocket to the same host as 'self'
        "worker-src 'self' blob:",
        "base-uri 'none'",
        "form-action 'none'",
        "frame-ancestors 'none'",
    )
)
_ALWAYS = {
    "content-security-policy": _POLICY,
    "x-content-type-options": "nosniff",
    "x-frame-options": "DENY",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "permissions-policy": "camera=(), microphone=(), geolocation=()",
}


_FOR_EVER = "public, max-age=31536000, immutable"
_FOLDERS = ("/assets/", "/mesh/")
"""What lies there is named by its content."""


class StrictHeaders:
    """Adds them to every answer."""

    def __init__(self, app: ASGIApp) -> None:
        self._app = app

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Pass a request on, and its answer back with the headers."""

        async def send_with(message: Message) -> None:
            if message["type"] == "http.response.start":
                headers = MutableHeaders(scope=message)
                for name, value in _ALWAYS.items():
                    headers.setdefault(name, value)  # a page may have a policy that is stricter
                headers["cache-control"] = _FOR_EVER if _is_for_ever(scope["path"], message["status"]) else "no-store"
            await send(message)

        await self._app(scope, receive, send_with)


def _is_for_ever(path: str, status: int) -> bool:
    """Whether an answer is the same whenever it is asked for; a mesh that is not there may be made."""
    return path.startswith(_FOLDERS) and (status < 300 or path.startswith(_FOLDERS[0]))
