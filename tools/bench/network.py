"""What it costs that sites are found: so many cards at one router, announced, listed, judged, missed; files of cards.

Usage: python tools/bench/network.py [CARDS] [PROCESSES]. PROCESSES announce CARDS in all, each card over a connection
of its own, at a router of its own process; needs `eclipse-zenoh`. With PROCESSES 0 no router is asked.
"""

import multiprocessing
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Sequence
from datetime import UTC, datetime, timedelta
from pathlib import Path
from statistics import median
from tempfile import TemporaryDirectory

from onika.fabric.address_book import AddressBook
from onika.fabric.card import OfferedRuntime, VisitingCard
from onika.fabric.listing import CardJudge
from onika.fabric.place import RouterPlace
from onika.fabric.router_cards import router_cards
from onika.fabric.signed_card import bound, opened, signed, unbound
from onika.fabric.zenoh_program import announce, route
from onika.words.reason import Reason

_NOW = datetime.now(UTC)
_UNTIL = (_NOW + timedelta(days=90)).date()
_IDLE_S = 8.0
_LONGEST_S = 30.0


def made(folder: Path, count: int) -> list[bytes]:
    """Cards of so many sites, signed by one key: what is judged is as much work."""
    key = folder / "key"
    subprocess.run(["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-f", str(key)], check=True)
    cards = []
    for number in range(count):
        runtime = OfferedRuntime(f"wss://robots{number}.example.org:7994", (f"arm{number}", "hand"))
        library = f"https://robots{number}.example.org/library"
        card = VisitingCard(f"site{number}", int(_NOW.timestamp()), _UNTIL, "x" * 80, (runtime,), (library,))
        content = signed(card, key)
        assert not isinstance(content, Reason), content
        cards.append(content)
    return cards


def files(cards: Sequence[bytes]) -> None:
    """A file of cards, and how long a look at them takes."""
    began = time.perf_counter()
    whole = bound(cards)
    print(f"phonebook of {len(cards)}: {len(whole)} bytes, {len(whole) / len(cards):.0f} a card", end=", ")
    print(f"bound in {time.perf_counter() - began:.2f} s", flush=True)
    began = time.perf_counter()
    assert unbound(whole) == tuple(cards)
    print(f"unbound in {(time.perf_counter() - began) * 1e3:.0f} ms")
    few, judge = cards[:100], CardJudge(opened)
    began = time.perf_counter()
    judge.listing(few, AddressBook(), _NOW.date(), lambda: True)
    print(f"judged: {(time.perf_counter() - began) / len(few) * 1e3:.1f} ms a card", end=", ")
    quick = CardJudge(lambda content: Reason.of("store.signature_bad"))
    began = time.perf_counter()
    quick.listing(cards, AddressBook(), _NOW.date(), lambda: True)
    print(f"all else of a look: {(time.perf_counter() - began) / len(cards) * 1e6:.0f} us a card", flush=True)


def used(process_id: int) -> tuple[float, float]:
    """Seconds of processor time and MB of memory of a process."""
    words = Path(f"/proc/{process_id}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(words[11]) + int(words[12])) / 100, int(words[21]) * 4096 / 1e6


def be_router(place: str) -> None:
    """The router's process."""
    route([place], [], None, threading.Event(), lambda: None)


def be_sites(cards: Sequence[bytes], place: str, ready: "multiprocessing.synchronize.Semaphore") -> None:
    """A process that announces cards, each over a connection of its own."""
    for card in cards:
        threading.Thread(target=announce, args=([card], place, None, threading.Event(), ready.release)).start()


def routed(cards: Sequence[bytes], processes: int) -> None:
    """Announce, list, idle and miss them at one router."""
    start = multiprocessing.get_context("spawn")
    with socket.create_server(("127.0.0.1", 0)) as free:
        place = f"tcp/127.0.0.1:{free.getsockname()[1]}"
    router = start.Process(target=be_router, args=(place,), daemon=True)
    router.start()
    while isinstance(router_cards(RouterPlace(place), 2.0), Reason):
        assert router.is_alive()
    assert router.pid is not None
    empty = used(router.pid)
    ready, began = start.Semaphore(0), time.perf_counter()
    sites = [start.Process(target=be_sites, args=(cards[k::processes], place, ready)) for k in range(processes)]
    for site in sites:
        site.start()
    for _ in cards:
        assert ready.acquire(timeout=300)
    print(f"{len(cards)} announced by {processes} processes in {time.perf_counter() - began:.1f} s", end=", ")
    there = used(router.pid)
    each_ms = (there[0] - empty[0]) / len(cards) * 1e3
    print(f"router {there[1]:.0f} MB ({empty[1]:.0f} empty), {each_ms:.1f} ms of CPU each")
    began, counts = time.perf_counter(), [0]
    while counts[-1] < len(cards) and time.perf_counter() - began < _LONGEST_S:
        counts.append(listed(place)[0])
    print(f"all told {time.perf_counter() - began:.1f} s later: {counts[1:]}")
    looks = [listed(place) for _ in range(5)]
    took = f"{median(took_s for _, took_s in looks):.2f} s"
    print(f"listed by a process of its own in {took}, its start included: {[count for count, _ in looks]}", flush=True)
    before, began = used(router.pid)[0], time.perf_counter()
    time.sleep(_IDLE_S)
    share = (used(router.pid)[0] - before) / (time.perf_counter() - began)
    print(f"idle: router {share * 100:.1f} % of a core, a process of sites {used(sites[0].pid or 0)[1]:.0f} MB")
    for site in sites:
        site.kill()
    began, left = time.perf_counter(), len(cards)
    while left:
        found = router_cards(RouterPlace(place), 10.0)
        left = 0 if isinstance(found, Reason) else len(found)
    print(f"all missed {time.perf_counter() - began:.1f} s after they were killed, asking included", flush=True)
    router.kill()


def listed(place: str) -> tuple[int, float]:
    """How many different cards are listed, and how long that takes."""
    began = time.perf_counter()
    found = router_cards(RouterPlace(place), 30.0)
    assert not isinstance(found, Reason), found
    return len(set(found)), time.perf_counter() - began


def main(count: int, processes: int) -> None:
    """Measure all."""
    with TemporaryDirectory() as folder:
        cards = made(Path(folder), count)
        files(cards)
        if processes:
            routed(cards, processes)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100, int(sys.argv[2]) if len(sys.argv) > 2 else 100)
