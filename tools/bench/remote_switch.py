"""Switching behind a slow link: the environment is 200 ms away, there and back, and the arm must not notice.

The assembly is run on a runtime that listens, through a proxy that hands on every byte at once, and then half of the
delay after it came. The plan is with the runtime, so that a switch asks nobody: the times of `switch.py` stay, only
the run's events come later.
"""

import argparse
import asyncio
import json
import os
import re
import statistics
import sys
import tempfile
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from pathlib import Path

ONIKA = str(Path(sys.executable).with_name("onika"))


class SlowLink:
    """A proxy on this machine; `delay_s` is one way."""

    def __init__(self, port: int, delay_s: float) -> None:
        self._port = port
        self._delay_s = delay_s
        self._ways: set[asyncio.Task[None]] = set()

    async def serve(self) -> asyncio.Server:
        """Begin; the server's socket tells the port."""
        return await asyncio.start_server(self._join, "127.0.0.1", 0)

    async def _join(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        there, back = await asyncio.open_connection("127.0.0.1", self._port)
        for ends in ((reader, back), (there, writer)):
            way = asyncio.create_task(self._carry(*ends))
            self._ways.add(way)
            way.add_done_callback(self._ways.discard)

    async def _carry(self, source: asyncio.StreamReader, sink: asyncio.StreamWriter) -> None:
        """One way: each piece is handed on when its time has come, however many are under way."""
        under_way: asyncio.Queue[tuple[float, bytes]] = asyncio.Queue()
        loop = asyncio.get_running_loop()

        async def hand_on() -> None:
            piece = b" "
            while piece:
                due, piece = await under_way.get()
                await asyncio.sleep(due - loop.time())
                sink.write(piece)
            sink.close()

        handing = asyncio.create_task(hand_on())
        piece = b" "
        while piece:
            try:
                piece = await source.read(1 << 16)
            except ConnectionError:
                piece = b""
            under_way.put_nowait((loop.time() + self._delay_s, piece))
        await handing


@asynccontextmanager
async def runtime(state: Path) -> AsyncIterator[tuple[int, Path]]:
    """A runtime that listens on this machine: its port and the file of its token."""
    words = (sys.executable, "-m", "onika.host", "--listen", "127.0.0.1:0")
    environment = os.environ | {"XDG_STATE_HOME": str(state)}
    process = await asyncio.create_subprocess_exec(*words, env=environment, stdout=asyncio.subprocess.PIPE)
    try:
        assert process.stdout is not None
        said = (await process.stdout.readline()).decode()
        found = re.search(r"listening on ws://127\.0\.0\.1:(\d+), token in (.*)", said)
        assert found, said
        yield int(found[1]), Path(found[2])
    finally:
        process.terminate()
        await process.wait()


async def switches(application: str, port: int, token: Path) -> tuple[list[float], float]:
    """Microseconds of every switch of a run on the runtime behind this port, and the seconds that the command took."""
    began = asyncio.get_running_loop().time()
    options = ("--json", "--runtime", f"ws://127.0.0.1:{port}", "--token-file", str(token))
    ran = await asyncio.create_subprocess_exec(ONIKA, "run", application, *options, stdout=asyncio.subprocess.PIPE)
    said, _ = await ran.communicate()
    result = json.loads(said.splitlines()[-1])
    assert result["state"] == "completed", result
    return result["switches_us"], asyncio.get_running_loop().time() - began


async def round_trip(port: int) -> float:
    """Seconds until a runtime that is asked nonsense has said so."""
    began = asyncio.get_running_loop().time()
    reader, writer = await asyncio.open_connection("127.0.0.1", port)
    writer.write(b"GET / HTTP/1.1\r\n\r\n")
    await reader.read(1)
    writer.close()
    return asyncio.get_running_loop().time() - began


async def measure(application: str, round_trip_s: float) -> None:
    """Both ways, each with a runtime of its own."""
    print(f"{'link':<20}{'switches':>9}{'median us':>11}{'p90 us':>9}{'max us':>9}{'run s':>8}")
    for delay_s in (0.0, round_trip_s / 2):
        with tempfile.TemporaryDirectory() as state:
            async with runtime(Path(state)) as (port, token):
                server = await SlowLink(port, delay_s).serve()
                took = await round_trip(server.sockets[0].getsockname()[1])
                found, took_s = await switches(application, server.sockets[0].getsockname()[1], token)
                server.close()
        what = f"{took * 1e3:.0f} ms there and back"
        tenths = statistics.quantiles(found, n=10)
        numbers = f"{statistics.median(found):>11.0f}{tenths[-1]:>9.0f}{max(found):>9.0f}{took_s:>8.1f}"
        print(f"{what:<20}{len(found):>9}{numbers}")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--application", default="assemble")
    parser.add_argument("--round-trip-ms", type=float, default=200.0)
    given = parser.parse_args()
    asyncio.run(measure(given.application, given.round_trip_ms / 1e3))


if __name__ == "__main__":
    main()
