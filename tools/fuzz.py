"""Random messages at every boundary, for a while, with seeds that nobody has tried: what the soak does, budgeted.

Usage: python tools/fuzz.py [SECONDS] [SEED]. Each round prints its boundary, its seed and how many messages it took;
one that fails prints how, and how it is done again. The exit code is 1 where one has failed.
"""

import importlib
import os
import sys
import time
import traceback
from collections.abc import Callable, Mapping
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

_TOP = Path(__file__).parents[1]
_ROUND = 2_000
"""Messages of a round."""


def _tests(name: str) -> Any:
    return importlib.import_module(f"tests.{name}")


def _requests(seed: int, _folder: Path) -> None:
    _tests("contract.test_requests_of_anybody").crowd_asks(seed, _ROUND)


def _wall(seed: int, folder: Path) -> None:
    tried = _tests("site.test_anybody")
    site = tried.Site(folder)
    try:
        tried.owner_asks(site, seed, _ROUND)
    finally:
        if site.process.poll() is None:
            site.process.kill()
            site.process.communicate()


def _acts(seed: int, folder: Path) -> None:
    pages = _tests("contract.test_acts_of_anybody").Pages(folder, seed)
    for number in range(_ROUND):
        pages.send(number)


def _editors(seed: int, folder: Path) -> None:
    editors = _tests("contract.test_several_editors").Editors(folder, seed)
    for number in range(_ROUND):
        editors.step(number)
    editors.end()


def _link(seed: int, _folder: Path) -> None:
    _tests("contract.test_bytes_of_anybody").link_hears(seed, _ROUND)


BOUNDARIES: Mapping[str, Callable[[int, Path], None]] = {
    "requests in virtual time": _requests,
    "requests in wall time": _wall,
    "acts of a page": _acts,
    "acts of several people": _editors,
    "bytes of a link": _link,
}


def main(words: list[str]) -> int:
    """So long, from this seed on."""
    sys.path[:0] = [str(_TOP), str(_TOP / "tests")]
    until = time.monotonic() + (float(words[0]) if words else 600.0)
    seed = int(words[1]) if len(words) > 1 else time.time_ns() % 10**9
    failed = taken = 0
    while time.monotonic() < until:
        for boundary, tried in BOUNDARIES.items():
            with TemporaryDirectory() as folder:
                os.environ["HOME"] = os.environ["XDG_STATE_HOME"] = folder
                os.chdir(folder)
                try:
                    tried(seed, Path(folder))
                except BaseException as wrong:
                    if isinstance(wrong, KeyboardInterrupt):
                        raise
                    failed += 1
                    traceback.print_exc()
                    print(f"{boundary}: seed {seed} FAILED; again: python tools/fuzz.py 0.001 {seed}", flush=True)
                finally:
                    os.chdir(_TOP)
            taken += _ROUND
            print(f"{boundary}: seed {seed}, {_ROUND} messages; {taken} in all, {failed} failed", flush=True)
        seed += 1
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
