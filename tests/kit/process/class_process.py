"""A class as a process, with browsers that are none: they keep cookies, are led elsewhere, talk over WebSockets."""

import http.client
import json
import os
import re
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any
from urllib.parse import urlencode, urlsplit

from websockets.sync.client import ClientConnection, connect
from websockets.typing import Origin

ONIKA = Path(sys.executable).with_name("onika")
PATIENCE_S = 120.0


class ClassBrowser:
    """One browser: its cookies are of the host, as browsers keep them, whatever the port."""

    def __init__(self, address: str) -> None:
        self.address = address
        self.cookies: dict[str, str] = {}
        self.host = ""
        """Where it has come to."""

    def ask(self, method: str, url: str, body: str = "", **headers: str) -> tuple[int, dict[str, str], str]:
        """Status, headers and body."""
        parts = urlsplit(url if "://" in url else self.address + url.lstrip("/"))
        link = http.client.HTTPConnection(parts.netloc, timeout=PATIENCE_S)
        cookies = "; ".join(f"{name}={value}" for name, value in self.cookies.items())
        sent = {"Cookie": cookies, "Origin": f"http://{parts.netloc}", **headers}
        link.request(method, parts.path + (f"?{parts.query}" if parts.query else ""), body, sent)
        answer = link.getresponse()
        text = answer.read().decode()
        for given in answer.headers.get_all("set-cookie") or ():
            name, _, value = given.partition(";")[0].partition("=")
            self.cookies[name] = value
        link.close()
        return answer.status, dict(answer.headers), text

    def follow(self, url: str) -> int:
        """Go there, wherever it leads; the last status."""
        status = 303
        while status == 303:
            parts = urlsplit(url if "://" in url else f"http://{self.host}{url}" if self.host else self.address + url)
            self.host = parts.netloc
            status, headers, _ = self.ask("GET", parts.geturl())
            url = headers.get("location", "")
        return status

    def join(self, code: str, name: str) -> int:
        """Take a seat, and go to it."""
        form = urlencode({"code": code, "name": name})
        status, _, _ = self.ask("POST", "/join", form, **{"Content-Type": "application/x-www-form-urlencoded"})
        return self.follow(f"{self.address}seat") if status == 303 else status

    def talk(self, host: str = "") -> ClientConnection:
        """The WebSocket of the page at which it is, or of another."""
        host = host or self.host
        cookies = "; ".join(f"{name}={value}" for name, value in self.cookies.items())
        origin, headers = Origin(f"http://{host}"), {"Cookie": cookies}
        return connect(
            f"ws://{host}/ws",
            additional_headers=headers,
            origin=origin,
            open_timeout=PATIENCE_S,
            ping_interval=None,  # nobody may read it for a while
            max_queue=None,
        )

    def hand_in(self) -> int:
        """What the page of a seat does."""
        return self.ask("POST", f"http://{self.host}/hand-in")[0]

    def board(self) -> dict[str, dict[str, Any]]:
        """The rows of the board, by learners."""
        return {row["learner"]: row for row in json.loads(self.ask("GET", "/board/state")[2])["rows"]}

    def wish(self, act: str, *seats: int, text: str = "") -> int:
        """What the board asks for."""
        return self.ask("POST", "/board/act", json.dumps({"act": act, "seats": seats, "text": text}))[0]

    def until(self, holds: Callable[[dict[str, dict[str, Any]]], object]) -> dict[str, dict[str, Any]]:
        """The rows as soon as that holds."""
        until_s = time.monotonic() + PATIENCE_S
        while not holds(rows := self.board()):
            assert time.monotonic() < until_s, rows
            time.sleep(0.1)
        return rows


class ClassProcess:
    """`onika class` in a folder, with the key of its board used."""

    def __init__(self, folder: Path, *words: str) -> None:
        self.folder = folder / "class"
        environment = os.environ | {"XDG_STATE_HOME": str(folder / "state"), "PYTHONUNBUFFERED": "1"}
        command = [str(ONIKA), "class", "--folder", str(self.folder), "--port", "0", "--no-browser", *words]
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, env=environment)
        assert self._process.stdout is not None
        first, second = self._process.stdout.readline(), self._process.stdout.readline()
        told = re.search(r"(http://\S+)\s+code: (\S+)", first)
        assert told is not None, first
        self.pid = self._process.pid
        self.address, self.code = told[1], told[2]
        self.teacher = ClassBrowser(self.address)
        self.teacher.follow(second.partition("http")[1] + second.partition("http")[2].strip())

    def browser(self) -> ClassBrowser:
        """Another one."""
        return ClassBrowser(self.address)

    def joined(self, name: str) -> ClassBrowser:
        """One that has come to a seat; whoever was there before has let him in again."""
        browser = self.browser()
        if name in self.teacher.board():
            self.teacher.wish("return", self.seat(name))
        assert browser.join(self.code, name) == 200
        return browser

    def seat(self, name: str) -> int:
        """The seat of a learner."""
        seat: int = self.teacher.board()[name]["seat"]
        return seat

    def end(self) -> int:
        """Ctrl-C; its exit code."""
        self._process.send_signal(signal.SIGINT)
        try:
            return self._process.wait(PATIENCE_S)
        finally:
            self._process.kill()
            assert self._process.stdout is not None
            self._process.stdout.close()


def until(socket: ClientConnection, wanted: Callable[[dict[str, Any]], object]) -> dict[str, Any]:
    """The first message that is wanted; those before it are passed over."""
    while True:
        message: dict[str, Any] = json.loads(socket.recv(timeout=PATIENCE_S))
        if wanted(message):
            return message


def done(socket: ClientConnection, **act: Any) -> dict[str, Any]:
    """The answer to an act."""
    socket.send(json.dumps({"cid": 7, "act": act}))
    return until(socket, lambda message: message.get("cid") == 7)
