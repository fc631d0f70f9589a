"""The process of a sandbox: it confines itself, then loads one module and carries out its entry points (R-X16)."""

import argparse
import gc
import os
import select
import signal
import site
import socket
import sys
from collections.abc import Iterable
from pathlib import Path

import onika
from onika.host.guards.memory_limit import bound
from onika.host.processes.output_pipe import open_output_pipes
from onika.host.processes.preloaded_libraries import preload
from onika.host.processes.realtime_scheduling import SANDBOX_PRIORITY, fine_timers, first_in_first_out, lock_memory
from onika.link.child.launcher import ONE_THREAD, die_with_parent
from onika.process import confinement, system_calls
from onika.ring.segment import Segment
from onika.runtime.sandbox.confined_instance import ConfinedInstance
from onika.runtime.sandbox.sandbox_messages import Refused, decode_order, encode
from onika.runtime.sandbox.sandboxed_module import CYCLE, CYCLE_LETTER, NOTHING_CAME_OF_IT
from onika.words.reason import NOTHING, Reason
from onika.words.system_error import system_reason

LARGEST = 1 << 20
"""Bytes of a message, either way."""
_HARMLESS = frozenset(("HOME", "LANG", "LC_ALL", "PATH", "TZ"))
_SYSTEM = ("/usr", "/lib", "/lib64", "/dev/null", "/dev/zero", "/dev/urandom", "/etc/ld.so.cache", "/etc/localtime")


def refusal(*reads: Path) -> Reason:
    """Confine this process: it computes, and reads the files of Python and these. Why not; NOTHING: it is confined."""
    preload()
    for name in os.environ.keys() - _HARMLESS - ONE_THREAD.keys():
        del os.environ[name]  # a secret may stand there
    try:
        confinement.confine((*_readable(), *reads), ())
        system_calls.leave_only_computing()
    except OSError as refused:
        return Reason.of("host.sandbox_refused", why=system_reason(refused))
    return NOTHING


def _readable() -> Iterable[Path]:
    """What Python is made of, and this package; nothing of a user."""
    own = (sys.prefix, sys.base_prefix, sys.exec_prefix, *site.getsitepackages(), *onika.__path__)
    return [Path(path) for path in (*_SYSTEM, *own)]


def _serve(post: socket.socket, instance: ConfinedInstance) -> None:
    """One message after the other, until the other end is closed."""
    while message := post.recv(LARGEST):
        if message[:1] == CYCLE_LETTER:
            _, now, published = CYCLE.unpack(message)
            returned = instance.cycle(now, published)
            post.send(NOTHING_CAME_OF_IT if returned is None else _packed(returned))
        else:
            post.send(_packed(instance.answer(decode_order(message))))


def _packed(answer: object) -> bytes:
    try:
        body = encode(answer)
    except (TypeError, ValueError, OverflowError) as wrong:  # what a module gives out need not be fit to be sent
        return encode(Refused(Reason.plain(str(wrong))))
    return (
        body
        if len(body) < LARGEST
        else encode(Refused(Reason.of("host.answer_too_long", size=len(body), most=LARGEST)))
    )


def main(words: list[str]) -> None:
    """The process."""
    parser = argparse.ArgumentParser()
    for option in ("--fd", "--memory-fd", "--parent"):
        parser.add_argument(option, type=int, required=True)
    parser.add_argument("--reads", type=Path, action="append", default=[])
    parser.add_argument("--fifo", action="store_true")
    given = parser.parse_args(words)
    die_with_parent(given.parent)
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    open_output_pipes()
    post = socket.socket(fileno=given.fd)
    post.setsockopt(socket.SOL_SOCKET, socket.SO_SNDBUF, 2 * LARGEST)
    memory = Segment.attach(given.memory_fd)
    bound()
    fine_timers()
    lock_memory()
    if given.fifo:
        first_in_first_out(SANDBOX_PRIORITY)
    gc.freeze()
    refused = refusal(*given.reads)
    if refused:
        post.send(encode(Refused(refused)))
        select.select([post], [], [])
        return
    _serve(post, ConfinedInstance(memory.view))


if __name__ == "__main__":
    main(sys.argv[1:])
