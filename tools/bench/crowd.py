"""How an honest user fares beside a crowd at the door: at the page's port, and at the port where a runtime listens.

Usage: python tools/bench/crowd.py [CONNECTIONS] [SECONDS]. So many connections come from this machine, half of them
silent, half dribbling a sign now and then; whoever is cut comes again. Meanwhile a page places a task, takes it back
and saves, again and again; another page comes in anew; and a session asks a runtime what is there.
"""

import asyncio
import contextlib
import os
import re
import resource
import subprocess
import sys
import threading
import time
import urllib.request
from collections.abc import Callable, Iterator
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from browse.guest import Guest

from onika.desk.run.remote_runtime import connect
from onika.wire import act, live

_ONIKA = str(Path(sys.executable).with_name("onika"))
_RATE_HZ = 1_000.0
"""Connections that are made in a second at most."""


class Crowd:
    """Connections to one port that ask for nothing; it runs in a process of its own."""

    def __init__(self, port: int, count: int) -> None:
        words = [sys.executable, __file__, "--crowd", str(port), str(count)]
        self._process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True)

    def wait(self) -> None:
        """Until all have tried once."""
        assert self._process.stdout is not None
        print("  ", self._process.stdout.readline().strip())

    def end(self) -> str:
        """Send them home; how often they were cut."""
        self._process.terminate()
        rest, _ = self._process.communicate(timeout=30)
        return rest.strip()


async def _press(port: int, count: int) -> None:
    """Hold so many connections open, and open anew what is cut."""
    cut = 0
    is_over = asyncio.Event()
    asyncio.get_running_loop().add_signal_handler(15, is_over.set)

    async def hold(number: int) -> None:
        nonlocal cut
        await asyncio.sleep(number / _RATE_HZ)
        while True:
            with contextlib.suppress(OSError):
                source = (f"127.0.0.{2 + number % 50}", 0) if number % 4 == 0 else ("127.0.0.1", 0)
                reader, writer = await asyncio.open_connection("127.0.0.1", port, local_addr=source)
                if number % 2:
                    for sign in b"GET / HTTP/1.1\r\nHost: 127.0.0.1\r\nX-A: " + b"a" * 1000:
                        writer.write(bytes((sign,)))
                        await asyncio.sleep(1.0)
                        if reader.at_eof() or writer.is_closing():
                            break
                else:
                    await reader.read()
                writer.close()
            cut += 1
            await asyncio.sleep(count / _RATE_HZ)

    tasks = [asyncio.create_task(hold(number)) for number in range(count)]
    await asyncio.sleep(count / _RATE_HZ + 1.0)
    print(f"{count} connections have come; {cut} were cut", flush=True)
    await is_over.wait()
    print(f"{cut} were cut in all", flush=True)
    os._exit(0 if tasks else 1)


def _times(seconds: float, each: Callable[[], float]) -> list[float]:
    """What `each` takes, again and again for so long, in ms."""
    taken, until = [], time.monotonic() + seconds
    while time.monotonic() < until:
        taken.append(each() * 1e3)
        time.sleep(0.02)
    return taken


def _tell(what: str, taken: list[float]) -> None:
    ordered = sorted(taken)
    late = ordered[int(0.99 * (len(ordered) - 1))]
    print(f"   {what}: median {median(taken):.1f} ms, 99 of 100 within {late:.1f} ms, longest {ordered[-1]:.1f} ms, "
          f"{len(taken)} times")  # fmt: skip


@contextlib.contextmanager
def _page(folder: Path) -> Iterator[tuple[list[str], Path]]:
    """A page's server without a runtime; its addresses, newest last, and what it prints."""
    base = folder / "base"
    (base / "module").mkdir(parents=True)
    (base / "module" / "a.rmod").write_text(
        "MODULE a\nDESC a\nINCONST none\nOUTCONST none\nINVAR none\nOUTVAR Q\nTASKTYPE periodic\nFREQ 1\nEOF\n"
    )
    output = folder / "output"
    words = [_ONIKA, "page", "--port", "0", "--no-browser", "--no-connect", "--base", str(base)]
    environment = os.environ | {"HOME": str(folder), "XDG_STATE_HOME": str(folder / "state")}
    with output.open("wb") as errors:
        process = subprocess.Popen(words, stdout=subprocess.PIPE, stderr=errors, text=True, env=environment)
    addresses: list[str] = []

    def listen() -> None:
        for line in process.stdout or ():
            addresses.extend(re.findall(r"http://\S+", line))

    threading.Thread(target=listen, daemon=True).start()
    while not addresses:
        time.sleep(0.05)
    try:
        yield addresses, output
    finally:
        process.terminate()
        process.wait(20)


def page(folder: Path, count: int, seconds: float) -> None:
    """The door of the page."""
    print(f"the page's port, {count} connections")
    with _page(folder) as (addresses, output):
        guest = Guest(addresses[-1])
        base, doc = str(folder / "base"), ""
        guest.socket.send('{"cid":99,"act":{"t":"New"}}')
        while not doc:
            answer = guest.answer(99)
            doc = answer["value"]
        guest.do(act.Save(doc, "job", base))

        def work() -> float:
            taken = guest.do(act.Place(doc, "a", 10, 10)) + guest.do(act.Undo(doc))
            return taken / 2

        def save() -> float:
            return guest.do(act.Save(doc, "job", base, overwrites=True))

        _tell("an act, alone", _times(2.0, work))
        crowd = Crowd(int(addresses[0].split(":")[2].split("/")[0]), count)
        crowd.wait()
        _tell("an act beside the crowd", _times(seconds, work))
        _tell("a save beside the crowd", _times(seconds / 2, save))

        def come() -> float:
            began = time.perf_counter()
            with contextlib.suppress(OSError), urllib.request.urlopen(addresses[0].partition("/?")[0], timeout=5):
                pass
            return time.perf_counter() - began

        _tell("to be answered at the door", _times(seconds / 2, come))
        print("  ", crowd.end())
        print(f"   printed: {len(output.read_bytes())} bytes")


def link(folder: Path, count: int, seconds: float) -> None:
    """The door of a runtime that listens."""
    print(f"the port of a runtime, {count} connections")
    words = [sys.executable, "-m", "onika.host", "--virtual", "--listen", "127.0.0.1:0"]
    environment = os.environ | {"XDG_STATE_HOME": str(folder / "state")}
    process = subprocess.Popen(words, stdout=subprocess.PIPE, text=True, env=environment)
    assert process.stdout is not None
    match = re.search(r"listening on (\S+?), token in (.*)$", process.stdout.readline())
    assert match is not None
    url, token = match[1], Path(match[2]).read_text().strip()
    try:
        with connect(url, token) as runtime:

            def ask() -> float:
                began = time.perf_counter()
                runtime.ask(live.Survey())
                return time.perf_counter() - began

            def come() -> float:
                began = time.perf_counter()
                with connect(url, token):
                    return time.perf_counter() - began

            _tell("a question, alone", _times(2.0, ask))
            crowd = Crowd(int(url.rpartition(":")[2].rstrip("/")), count)
            crowd.wait()
            _tell("a question beside the crowd", _times(seconds, ask))
            _tell("to come in beside the crowd", _times(seconds / 2, come))
            print("  ", crowd.end())
    finally:
        process.terminate()
        process.wait(20)


def main(words: list[str]) -> None:
    """Both doors."""
    most = resource.getrlimit(resource.RLIMIT_NOFILE)[1]
    resource.setrlimit(resource.RLIMIT_NOFILE, (most, most))
    if words[:1] == ["--crowd"]:
        asyncio.run(_press(int(words[1]), int(words[2])))
        return
    count = int(words[0]) if words else 5_000
    seconds = float(words[1]) if len(words) > 1 else 10.0
    for door in (page, link):
        with TemporaryDirectory() as folder:
            door(Path(folder), count, seconds)


if __name__ == "__main__":
    main(sys.argv[1:])
