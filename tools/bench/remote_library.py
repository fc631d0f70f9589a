"""A library of a thousand tasks at another site: how long it takes to list it, to fetch a program's code, to open it.

Without words a server on this machine is asked through a proxy that hands every byte on half of the delay after it
came, and the first ones of a connection a whole delay later still, for the handshake of TCP. That is a line without
losses and without a slow start. For a real line, or one that is simulated beneath TCP: `--serve HOST` there, then
`--ask HOST` here, both with the same `--folder`.
"""

import argparse
import asyncio
import os
import random
import re
import ssl
import subprocess
import tempfile
import threading
from contextlib import suppress
from datetime import UTC, datetime
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from time import perf_counter
from typing import BinaryIO

from onika.store.remote.library_access import LibraryAccess
from onika.store.remote.lock_file import LockFile
from onika.store.remote.object_cache import ObjectCache
from onika.store.remote.publication import Publication, Publisher
from onika.store.remote.remote_libraries import Offer, RemoteLibraries
from onika.store.shipped import shipped
from onika.store.site import open_site

_PORT = 8443
_TASKS, _MODULES, _CONFIGURATIONS, _CLOSURE = 1000, 250, 200, 12
_TODAY = datetime.now(UTC).date()


def make(folder: Path) -> None:
    """A library out of the shipped laboratories, its words by chance, published with a key and a certificate."""
    chance = random.Random(1)
    base, labs = folder / "far", shipped()
    words = ["".join(chance.choice("abcdefghijklmnoprstuvw") for _ in range(chance.randint(3, 9))) for _ in range(1000)]

    def words_of(count: int) -> str:
        return " ".join(chance.choice(words) for _ in range(count))

    for name in ("module", "conf"):
        (base / name).mkdir(parents=True)
    codes, tasks, configurations = (
        sorted(labs.glob(f"*/{form}")) for form in ("module/*.py", "module/*.rmod", "conf/*.conf")
    )
    for number in range(_MODULES):
        lines = chance.choice(codes).read_text().splitlines()
        varied = (line + f"  # {words_of(2)}" * (chance.random() < 0.3) for line in lines)
        (base / f"module/m{number}.py").write_text("\n".join(varied))
    for number in range(_TASKS):
        new = {"MODULE": f"MODULE      m{number % _MODULES}", "DESC": f"DESC        {words_of(4)}"}
        lines = chance.choice(tasks).read_text().splitlines()
        text = "\n".join(new.get((line.split() or [""])[0], line) for line in lines)
        (base / f"module/t{number}.rmod").write_text(text + "\n")
    for number in range(_CONFIGURATIONS):
        (base / f"conf/c{number}.conf").write_text(chance.choice(configurations).read_text() + f"# {words_of(2)}\n")
    subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", folder / "key"], check=True)
    done = Publisher(base, folder / "public", folder / "key", "far").publish(_TODAY)
    assert isinstance(done, Publication), done
    names = "subjectAltName=IP:127.0.0.1,IP:10.9.0.1"
    request = ["openssl", "req", "-x509", "-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes"]
    request += ["-keyout", f"{folder}/tls.key", "-out", f"{folder}/tls.crt", "-subj", "/CN=far", "-addext", names]
    subprocess.run(request, check=True, capture_output=True)
    print(f"{_TASKS} tasks, {_MODULES} modules, {_CONFIGURATIONS} configurations: index of {done.packed} bytes")


class _Quiet(SimpleHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    disable_nagle_algorithm = True  # as every real server does: else head and body of an answer take a trip each

    def send_head(self) -> BytesIO | BinaryIO | None:
        """A file, or the piece of it that is asked for, as every real server answers it."""
        span = re.match(r"bytes=(\d+)-(\d+)\Z", self.headers.get("Range", ""))
        if span is None:
            return super().send_head()
        whole = Path(self.translate_path(self.path)).read_bytes()
        piece = whole[int(span[1]) : int(span[2]) + 1]
        self.send_response(206)
        self.send_header("Content-Range", f"bytes {span[1]}-{int(span[1]) + len(piece) - 1}/{len(whole)}")
        self.send_header("Content-Length", str(len(piece)))
        self.end_headers()
        return BytesIO(piece)

    def log_message(self, *_: object) -> None:
        """Nothing is printed."""


def server(folder: Path, host: str, port: int) -> ThreadingHTTPServer:
    """A server of the published files over TLS."""
    made = ThreadingHTTPServer((host, port), partial(_Quiet, directory=str(folder / "public")))
    context = ssl.create_default_context(ssl.Purpose.CLIENT_AUTH)
    context.load_cert_chain(folder / "tls.crt", folder / "tls.key")
    made.socket = context.wrap_socket(made.socket, server_side=True, do_handshake_on_connect=False)
    return made


async def slow_link(port: int, delay_s: float, ready: threading.Event, found: list[int]) -> None:
    """A proxy with this delay, there and back."""

    async def hand_on(reader: asyncio.StreamReader, writer: asyncio.StreamWriter, first_s: float) -> None:
        loop, earliest = asyncio.get_running_loop(), asyncio.get_running_loop().time() + first_s
        with suppress(OSError):
            while part := await reader.read(65536):
                loop.call_at(max(loop.time() + delay_s / 2, earliest), writer.write, part)
        loop.call_later(delay_s, writer.close)

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        there, back = await asyncio.open_connection("127.0.0.1", port)
        await asyncio.gather(hand_on(reader, back, 1.5 * delay_s), hand_on(there, writer, 0.0))

    listening = await asyncio.start_server(serve, "127.0.0.1", 0)
    found.append(listening.sockets[0].getsockname()[1])
    ready.set()
    await listening.serve_forever()


def ask(folder: Path, address: str, delay_s: float) -> None:
    """All of it once from cold, and how long each part takes."""
    os.environ["SSL_CERT_FILE"] = str(folder / "tls.crt")
    with tempfile.TemporaryDirectory() as name:
        home, cache = Path(name) / "home" / "onika", Path(name) / "cache"
        home.mkdir(parents=True)
        access = LibraryAccess(ObjectCache(cache / "onika"), None)
        libraries = RemoteLibraries(LockFile(home), access)
        times = [perf_counter()]
        offer = libraries.offer(address, _TODAY)
        times.append(perf_counter())
        assert isinstance(offer, Offer), offer
        library = libraries.add(offer, "")
        times.append(perf_counter())
        lacking = libraries.checkout(library).lacking()  # type: ignore[arg-type]
        assert not access.bring(address, lacking[:_CLOSURE])
        times.append(perf_counter())
        assert not access.bring(address, lacking, offer.index)
        times.append(perf_counter())
        access.close()
        open_site([], {"XDG_CACHE_HOME": str(cache)}, home.parent)
        times.append(perf_counter())
        assert not LibraryAccess(access.cache, None).bring(address, lacking)
    listed, kept, closure, rest, opened = (later - earlier for earlier, later in pairwise(times))
    trips = f", {closure / delay_s:.1f} round trips" if delay_s else ""
    print(f"listed from cold {listed:.2f} s; locked and written {kept:.2f} s; {_CLOSURE} files {closure:.2f} s{trips}")
    print(
        f"the other {len(lacking) - _CLOSURE} files {rest:.2f} s; search path opened offline {opened:.2f} s", flush=True
    )


def main() -> None:
    """Measure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--delay", type=float, default=0.2, metavar="S", help="there and back (0.2)")
    parser.add_argument("--times", type=int, default=3)
    parser.add_argument("--folder", type=Path, help="where the library is made, or was")
    parser.add_argument("--serve", metavar="HOST")
    parser.add_argument("--ask", metavar="HOST")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = given.folder or Path(name) / "library"
        if not folder.exists():
            make(folder)
        if given.serve:
            server(folder, given.serve, _PORT).serve_forever()
        if given.ask:
            for _ in range(given.times):
                ask(folder, f"https://{given.ask}:{_PORT}", given.delay)
            return
        far = server(folder, "127.0.0.1", 0)
        threading.Thread(target=far.serve_forever, daemon=True).start()
        ready, found = threading.Event(), list[int]()
        link = partial(slow_link, far.server_address[1], given.delay, ready, found)
        threading.Thread(target=lambda: asyncio.run(link()), daemon=True).start()
        ready.wait()
        for _ in range(given.times):
            ask(folder, f"https://127.0.0.1:{found[0]}", given.delay)


if __name__ == "__main__":
    main()
