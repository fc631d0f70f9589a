"""What a page sends as a form: short, of fields that stand in it once, and not for long on its way (F10, X25)."""

import asyncio
from urllib.parse import parse_qs

from starlette.requests import ClientDisconnect, Request

_LONGEST = 4096
"""Bytes of a form."""
_PATIENCE_S = 10.0
"""How long a form may take to come."""
_KIND = "application/x-www-form-urlencoded"
_MOST_FIELDS = 4


async def sent_form(request: Request, *names: str) -> tuple[str, ...] | None:
    """The fields of these names, in their order; None: it is no form, is too large or does not come."""
    if request.headers.get("content-type", "").partition(";")[0].strip().lower() != _KIND:
        return None
    body = await sent_body(request)
    if body is None:
        return None
    try:
        text = body.decode("ascii")
        fields = parse_qs(
            text, strict_parsing=True, max_num_fields=_MOST_FIELDS, errors="strict", keep_blank_values=True
        )
    except ValueError:
        return None
    values = [fields.get(name, []) for name in names]
    return tuple(value[0] for value in values) if all(len(value) == 1 for value in values) else None


async def sent_body(request: Request) -> bytes | None:
    """The whole body; None as soon as it is too large, and where it does not come."""
    try:
        return await asyncio.wait_for(_body(request), _PATIENCE_S)
    except (ClientDisconnect, TimeoutError, ValueError):
        return None


async def _body(request: Request) -> bytes:
    """Raises ValueError for what is too large."""
    body = b""
    async for piece in request.stream():
        body += piece
        if len(body) > _LONGEST:
            raise ValueError(len(body))
    return body
