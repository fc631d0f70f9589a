"""All that speaks Zenoh, in a process of its own: a router, the announcing of cards, the asking for them (F06).

Zenoh carries hints only: nothing that moves a robot hangs on this process, which may end at any moment. Its open
defaults are set: it listens where it is told, finds others by multicast only where `lan` is asked for, drops what
cannot be sent, and gives up a peer after two seconds of silence.
"""

import base64
import json
import sys
import threading
import time
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from onika.fabric.card import LARGEST
from onika.fabric.signed_card import MOST_CARDS, digest

CARDS = "onika/card"
HERE = "onika/here"
PORT = 7447
_LEASE_MS = 2000
_MOST_SESSIONS = 5000
_MOST_PENDING = 500
_FEW = 50
"""Cards that are asked for at a time."""
_LONGEST_PREFIX = 4
_TRIES = 3


def settings(
    mode: str, connect: Iterable[str] = (), listen: Iterable[str] = (), *, is_lan: bool = False, waits_s: float = 0.0
) -> Mapping[str, Any]:
    """The settings of a session of Zenoh that are not its own; `waits_s`: until a connection is given up, 0: never."""
    return {
        "mode": mode,
        "connect/endpoints": list(connect),
        "connect/timeout_ms": round(waits_s * 1e3) or -1,
        "connect/exit_on_failure": waits_s > 0,
        "listen/endpoints": list(listen),
        "scouting/multicast/enabled": is_lan,
        "scouting/gossip/enabled": False,
        "transport/link/tx/lease": _LEASE_MS,
        "transport/shared_memory/enabled": False,
        "transport/unicast/max_sessions": _MOST_SESSIONS,
        "transport/unicast/accept_pending": _MOST_PENDING,
    }


def session(given: Mapping[str, Any], file: Path | None = None) -> Any:
    """A session of Zenoh, behind what a file says of certificates, users, access; raises OSError, ImportError."""
    import zenoh

    config = zenoh.Config() if file is None else zenoh.Config.from_file(str(file))
    for key, value in given.items():
        config.insert_json5(key, json.dumps(value))
    try:
        return zenoh.open(config)
    except zenoh.ZError as error:
        raise OSError(str(error)) from None


def route(
    listen: Sequence[str], peers: Sequence[str], file: Path | None, until: threading.Event, ready: Callable[[], None]
) -> None:
    """Be a router until the end; raises OSError where it cannot listen."""
    with session(settings("router", peers, listen, is_lan=_is_for_all(listen)), file):
        ready()
        until.wait()


def announce(
    cards: Sequence[bytes], place: str, file: Path | None, until: threading.Event, ready: Callable[[], None]
) -> None:
    """Have these signed cards answered for at a router, until the end; raises OSError."""
    with ExitStack() as kept:
        connection = kept.enter_context(session(settings("client", [place] if place else [], is_lan=not place), file))
        for card in cards:
            key = digest(card)[:32]
            kept.callback(connection.declare_queryable(f"{CARDS}/{key}", _answering(f"{CARDS}/{key}", card)).undeclare)
            kept.callback(connection.liveliness().declare_token(f"{HERE}/{key}").undeclare)
        ready()
        until.wait()


def listed(place: str, waits_s: float, file: Path | None = None) -> Iterable[bytes]:
    """The signed cards that are answered for at a router, at most so many; raises OSError.

    What a router cannot pass on at once it drops: few are asked for at a time, and those that are lacking again.
    """
    with session(settings("client", [place] if place else [], is_lan=not place, waits_s=waits_s), file) as connection:
        until_s = time.monotonic() + waits_s
        tokens = connection.liveliness().get(f"{HERE}/*", timeout=waits_s)
        lacking = {_name(reply.ok.key_expr) for reply, _ in zip(tokens, range(MOST_CARDS), strict=False) if reply.ok}
        for _ in range(_TRIES):
            for asked in shards(lacking):
                for name, content in _answers(connection, asked, until_s - time.monotonic()):
                    if name in lacking:
                        lacking.discard(name)
                        yield content


def shards(names: Iterable[str], prefix: str = "") -> list[str]:
    """Expressions that name these cards, few by each; none where there are no names."""
    here = sorted(name for name in set(names) if name.startswith(prefix))
    if not here:
        return []
    if len(here) <= _FEW or len(prefix) >= _LONGEST_PREFIX:
        return [f"{CARDS}/{prefix}$*" if prefix else f"{CARDS}/*"]
    digits = sorted({name[len(prefix) : len(prefix) + 1] for name in here} - {""})
    return [shard for digit in digits for shard in shards(here, prefix + digit)]


def _answers(connection: Any, asked: str, left_s: float) -> Iterable[tuple[str, bytes]]:
    """Cards by their names, as they come; none where there is no time left."""
    import zenoh

    if left_s <= 0:
        return
    drop, each = zenoh.CongestionControl.DROP, zenoh.ConsolidationMode.NONE
    for reply in connection.get(asked, timeout=left_s, congestion_control=drop, consolidation=each):
        if reply.ok is None:
            continue
        content = bytes(reply.ok.payload)
        if len(content) <= LARGEST:
            yield _name(reply.ok.key_expr), content


def _name(key: object) -> str:
    return str(key).rpartition("/")[2]


def main(words: Sequence[str]) -> int:
    """`list PLACE SECONDS`: one card a line in base64, then END."""
    _, place, waits_s = words
    try:
        for card in listed(place, float(waits_s)):
            sys.stdout.write(base64.b64encode(card).decode() + "\n")
    except (OSError, ImportError) as wrong:
        sys.stderr.write(f"{wrong}\n")
        return 1
    sys.stdout.write("END\n")
    sys.stdout.flush()
    return 0


def _answering(key: str, card: bytes) -> Any:
    def answer(query: Any) -> None:
        query.reply(key, card)

    return answer


def _is_for_all(listen: Sequence[str]) -> bool:
    """Whether others than this machine are meant to reach it: only then it answers who looks for routers."""
    return any(not endpoint.partition("/")[2].startswith(("127.", "localhost", "[::1]")) for endpoint in listen)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
