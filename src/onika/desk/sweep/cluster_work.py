"""What a worker of a cluster does for a sweep: one case at a time on a runtime that stays warm (requirement X23).

Only bytes come and go. The worker has to have the same code as whoever asks, or its runs would be other runs.
"""

import atexit
import hashlib
import platform
from functools import cache
from importlib import metadata
from pathlib import Path
from socket import gethostname
from threading import Lock

import msgspec
from msgspec import Struct

import onika
from onika.desk.sweep import swept_program
from onika.desk.sweep.case import Case, CaseResult
from onika.desk.sweep.sweep import LONGEST_S
from onika.desk.sweep.warm_runtime import WarmRuntime
from onika.store.site import Site

_DECIDE = ("mujoco", "numpy")
"""Packages whose version decides what a virtual run is, bit for bit."""


class ClusterAnswer(Struct, frozen=True):
    """What a worker answers; without a result its code is another, `build`."""

    worker: str
    build: str
    result: CaseResult | None = None


encode = msgspec.msgpack.Encoder().encode
decode_answer = msgspec.msgpack.Decoder(ClusterAnswer).decode
_decode_case = msgspec.msgpack.Decoder(Case).decode


class KeptRuntimes:
    """The runtimes of this process that wait for a case of the program that they did last."""

    def __init__(self) -> None:
        self._lock = Lock()
        self._idle: list[tuple[bytes, WarmRuntime]] = []

    def do(self, program: bytes, case: Case) -> CaseResult:
        """Do a case of a program."""
        swept = swept_program.decode(program)
        digest = hashlib.sha256(program).digest()
        runtime = self._taken(digest) or WarmRuntime(swept.prepared, Site((), Path()))
        try:
            result = runtime.do(case, swept.design.settings_of(case), LONGEST_S)
        except BaseException:
            runtime.close()
            raise
        with self._lock:
            self._idle.append((digest, runtime))
        return result

    def _taken(self, digest: bytes) -> WarmRuntime | None:
        """One of this program; those of other programs end."""
        with self._lock:
            fitting = [pair for pair in self._idle if pair[0] == digest]
            others = [pair for pair in self._idle if pair[0] != digest]
            self._idle = fitting[1:]
        for _, runtime in others:
            runtime.close()
        return fitting[0][1] if fitting else None

    def close(self) -> None:
        """End all that wait."""
        with self._lock:
            idle, self._idle = self._idle, []
        for _, runtime in idle:
            runtime.close()


_kept = KeptRuntimes()
atexit.register(_kept.close)


def carry_out(program: bytes, case: bytes, build: str) -> bytes:
    """What comes of a case of a program, as a `ClusterAnswer`; a cluster calls this by its name.

    program   a `SweptProgram`
    case      a `Case`
    build     the code of whoever asks, by `own_build`
    """
    here = own_build()
    result = _kept.do(program, _decode_case(case)) if here == build else None
    return encode(ClusterAnswer(gethostname(), here, result))


@cache
def own_build() -> str:
    """A digest of all code by which a virtual run is what it is."""
    digest = hashlib.sha256(platform.python_version().encode())
    for package in _DECIDE:
        digest.update(f"{package} {metadata.version(package)}\n".encode())
    house = Path(onika.__file__).parent
    for path in sorted(house.rglob("*.py")):
        digest.update(str(path.relative_to(house)).encode())
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]
