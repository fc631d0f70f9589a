"""Messages of a WebSocket: assembled from their frames, complete and of bytes only."""

import logging

from websockets.frames import Frame, Opcode
from websockets.http11 import Request, Response

from onika.words.reason import Reason

SILENT = logging.Logger("onika.websocket", logging.CRITICAL + 1)
"""For the protocol's own remarks, which would name headers and so tokens: nobody hears them.

It is not among the loggers of the process: a library that sets up logging (Dask does) would let it speak again.
"""


class WebSocketMessages:
    """Frames in, payloads out; raises ValueError for a text, and the protocol itself for everything too long."""

    def __init__(self) -> None:
        self._begun: list[bytes] = []

    def feed(self, events: list[Request | Response | Frame]) -> list[bytes]:
        """The payloads that are whole now."""
        payloads: list[bytes] = []
        for frame in events:
            if not isinstance(frame, Frame) or frame.opcode not in (Opcode.TEXT, Opcode.BINARY, Opcode.CONT):
                continue  # pings are answered by the protocol
            if frame.opcode is Opcode.TEXT:
                raise ValueError(Reason.of("link.text_message"))
            self._begun.append(bytes(frame.data))
            if frame.fin:
                payloads.append(b"".join(self._begun))
                self._begun.clear()
        return payloads
