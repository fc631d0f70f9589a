"""Runtimes in virtual time that tests use one after the other: renewed between them, which no test can tell from new.

A start costs most of a second of processor, a renewal a thousandth of it. What a renewed runtime does is the same to
the bit (`tests/site/test_sweep.py`). Whoever looks at processes starts a runtime of its own.
"""

import os
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from kit.link.idle_start import IdleStart
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.link.lost import LinkLost
from onika.wire import live, request

_MOST = 3
"""Kept at a time."""
_OF_A_TEST = ("PYTEST_CURRENT_TEST",)
_Key = tuple[object, ...]


class WarmRuntimes:
    """In the place of the class of launched runtimes: called like it, it lends one."""

    def __init__(self) -> None:
        self._kept: dict[_Key, LaunchedRuntime] = {}

    @contextmanager
    def __call__(
        self,
        rtpus: Sequence[str],
        is_virtual: bool,
        with_fifo: bool = True,
        options: Sequence[str] = (),
        has_black_box: bool = True,
        start: IdleStart | None = None,
    ) -> Iterator[LaunchedRuntime]:
        """A runtime on which nothing has happened yet, kept afterwards where it is as good as new."""
        if not is_virtual or options:
            with LaunchedRuntime(rtpus, is_virtual, with_fifo, options, has_black_box) as runtime:
                yield runtime
            return
        environment = tuple(sorted((name, value) for name, value in os.environ.items() if name not in _OF_A_TEST))
        key = (tuple(rtpus), with_fifo, has_black_box, Path.cwd(), environment)
        taken = self._renewed(key) or LaunchedRuntime(rtpus, is_virtual, with_fifo, options, has_black_box).__enter__()
        try:
            yield taken
        except BaseException:
            taken.__exit__(None, None, None)
            raise
        self._keep(key, taken)

    def close(self) -> None:
        """End them all."""
        while self._kept:
            self._kept.pop(next(iter(self._kept))).__exit__(None, None, None)

    def _renewed(self, key: _Key) -> LaunchedRuntime | None:
        kept = self._kept.pop(key, None)
        if kept is None:
            return None
        try:
            is_new = isinstance(kept.ask(live.Renew()), request.Done)
            for _ in kept.events(0.0):  # what was told of the run before
                pass
        except (LinkLost, TimeoutError):
            is_new = False
        if not is_new:
            kept.__exit__(None, None, None)
        return kept if is_new else None

    def _keep(self, key: _Key, runtime: LaunchedRuntime) -> None:
        if key in self._kept:
            runtime.__exit__(None, None, None)
            return
        self._kept[key] = runtime
        if len(self._kept) > _MOST:
            self._kept.pop(next(iter(self._kept))).__exit__(None, None, None)
