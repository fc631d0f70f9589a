"""A browser without a window: it speaks as the page does."""

import json
import time
import urllib.error
import urllib.request
from typing import Any

import msgspec
from websockets.sync.client import connect

from onika.wire import act, page as messages


class Guest:
    """A browser without a window: it speaks as the page does."""

    def __init__(self, address: str) -> None:
        class Stays(urllib.request.HTTPRedirectHandler):
            def redirect_request(self, *_args: object) -> None:
                return None

        opener = urllib.request.build_opener(Stays)
        try:
            opener.open(address)
        except urllib.error.HTTPError as redirect:
            cookie = redirect.headers["set-cookie"].partition(";")[0]
        origin = address.partition("/?")[0]
        self.socket = connect(
            origin.replace("http", "ws") + "/ws", additional_headers={"Cookie": cookie}, origin=origin, max_size=None
        ).__enter__()
        self.cid = 0

    def do(self, asked: act.AnyAct) -> float:
        """Seconds until the answer."""
        began = time.perf_counter()
        self.ask(asked)
        return time.perf_counter() - began

    def ask(self, asked: act.AnyAct) -> Any:
        """What an act is answered with; raises RuntimeError with the reason where it is refused."""
        self.cid += 1
        self.socket.send(msgspec.json.encode(messages.Ordered(self.cid, asked)).decode())
        answer = self.answer(self.cid)
        if answer["t"] == "Refused":
            raise RuntimeError(answer["reason"])
        return answer.get("value")

    def frame(self) -> dict[str, Any]:
        """The next frame of what it watches."""
        while True:
            message: dict[str, Any] = json.loads(self.socket.recv())
            if message["t"] == "Frame":
                return message

    def answer(self, cid: int) -> dict[str, Any]:
        """The answer to the act of this number."""
        while True:
            message: dict[str, Any] = json.loads(self.socket.recv())
            if message.get("cid") == cid:
                return message

    def until(self, asked: act.AnyAct) -> None:
        """Ask again until it is done: a runtime takes a moment to begin."""
        for _ in range(100):
            try:
                self.do(asked)
                return
            except RuntimeError as refused:
                why = refused
                time.sleep(0.1)
        raise why
