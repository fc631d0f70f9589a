"""`onika runtime --hand-over`: what ssh starts on the machine of a robot (A15).

It starts a runtime that listens on its own machine only, says in one line on its output how it is reached, and ends
when its input does: then who called by ssh is gone. A runtime that is to stay is found again, and outlives it.
"""

import os
import select
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from onika.cli.language import say
from onika.desk.run.launched_runtime import LaunchedRuntime
from onika.desk.run.runtime_conversation import RuntimeConversation
from onika.files.state.staying_runtime import StayingRuntime, staying_path, staying_runtime
from onika.link.address import Address
from onika.link.child.launcher import ONE_THREAD, RUNTIME, UNDRAWN
from onika.link.lost import LinkLost
from onika.link.token import read_token, token_path
from onika.process.orderly_exit import in_order
from onika.wire import live
from onika.wire.hand_over import HandOver, line_of
from onika.wire.runtime_standing import Standing
from onika.words.reason import Reason

LISTEN = ("--listen", "127.0.0.1:0")
_START_S = 20.0
_LOOK_S = 0.05
_INPUT = 0


def hand_over(launched: LaunchedRuntime) -> int:
    """Hand over a runtime that ends with this program; the exit code."""
    with in_order():
        try:
            with launched as runtime:
                _say(HandOver(_port(runtime), read_token(token_path()), runtime.pid or 0))
                while not _input_has_ended(runtime):
                    list(runtime.events(0.0))
        except LinkLost as lost:
            return _complain(lost.reason)
    return 0


def hand_over_staying(words: Sequence[str]) -> int:
    """Hand over the runtime that stays, or one that is started with these words and stays; the exit code."""
    path = staying_path()
    staying, is_new = staying_runtime(path), False
    if staying is None:
        log = path.with_suffix(".log")
        staying, is_new = _started(words, path, log), True
        if staying is None:
            return _complain(Reason.of("cli.staying_not_started", log=str(log), said=_end_of(log)))
    _say(HandOver(staying.port, read_token(token_path()), staying.process, is_new=is_new))
    with in_order():
        while os.read(_INPUT, 4096):
            pass
    return 0


def _started(words: Sequence[str], path: Path, log: Path) -> StayingRuntime | None:
    """A runtime that nobody's end ends; of two who start one at a time only one comes to stay."""
    path.parent.mkdir(mode=0o700, parents=True, exist_ok=True)
    descriptor = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600)
    with os.fdopen(descriptor, "wb") as output:
        process = subprocess.Popen(  # noqa: S603  our own program
            [*RUNTIME, *LISTEN, "--stay", str(path), *words],
            stdin=subprocess.DEVNULL,
            stdout=output,
            stderr=output,
            env=UNDRAWN | os.environ | ONE_THREAD,
            start_new_session=True,
        )
    until = time.monotonic() + _START_S
    while (staying := staying_runtime(path)) is None and time.monotonic() < until:
        if process.poll() is not None:
            return staying_runtime(path)
        time.sleep(_LOOK_S)
    return staying


def _port(runtime: RuntimeConversation) -> int:
    standing = runtime.ask(live.Survey())
    if not isinstance(standing, Standing):
        raise TypeError("expected Standing")
    return Address.parse(standing.addresses[0]).port


def _input_has_ended(runtime: RuntimeConversation) -> bool:
    """Wait until something comes: from the runtime, or on the input, of which only the end counts."""
    readers, _, _ = select.select([_INPUT, *runtime.readers()], runtime.writers(), [], runtime.due_s())
    return _INPUT in readers and not os.read(_INPUT, 4096)


def _say(what: HandOver) -> None:
    sys.stdout.write(f"{line_of(what)}\n")
    sys.stdout.flush()


def _complain(reason: Reason) -> int:
    print(say(reason), file=sys.stderr)
    return 1


def _end_of(log: Path) -> Reason:
    return Reason.plain(log.read_text(encoding="utf-8", errors="replace").strip()[-2000:])
