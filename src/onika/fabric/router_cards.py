"""The cards at a router of Zenoh, asked by a process of its own that ends, or is ended, whatever comes (F06)."""

import base64
import binascii
import os
import select
import subprocess
import sys
import time
from importlib.util import find_spec

from onika.fabric.card import LARGEST
from onika.fabric.place import RouterPlace
from onika.fabric.signed_card import MOST_CARDS
from onika.words.reason import Reason

PROGRAM = (sys.executable, "-m", "onika.fabric.zenoh_program")
END = b"END"
"""The last line of a program that could ask."""
_MOST_BYTES = MOST_CARDS * (LARGEST * 4 // 3 + 8)


def router_cards(
    place: RouterPlace, patience_s: float, program: tuple[str, ...] = PROGRAM
) -> tuple[bytes, ...] | Reason:
    """The signed cards that are announced there, none of them judged; why none come."""
    if program is PROGRAM and find_spec("zenoh") is None:
        return Reason.of("fabric.no_zenoh")
    asking = subprocess.Popen(  # noqa: S603 - no shell; the place has the form of an endpoint
        [*program, "list", place.endpoint, f"{patience_s / 2:.1f}"],
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
    )
    try:
        lines = _lines(asking, time.monotonic() + patience_s)
    finally:
        asking.kill()
        asking.wait()
        if asking.stdout is not None:
            asking.stdout.close()
    if isinstance(lines, Reason):
        return lines
    if lines[-1:] != [END]:
        return Reason.of("fabric.router_silent", place=place.endpoint or "lan")
    return tuple(card for line in lines[:-1] if (card := _card(line)) is not None)


def _lines(asking: "subprocess.Popen[bytes]", until_s: float) -> list[bytes] | Reason:
    """What the program says until it ends, is done, or has had its time."""
    if asking.stdout is None:
        return []
    content, descriptor = bytearray(), asking.stdout.fileno()
    while (left_s := until_s - time.monotonic()) > 0:
        if not select.select([descriptor], [], [], left_s)[0]:
            break
        part = os.read(descriptor, 1 << 16)
        if not part:
            break
        content += part
        if len(content) > _MOST_BYTES:
            return Reason.of("fabric.book_many", most=MOST_CARDS)
        if content.endswith(END + b"\n"):
            break
    return bytes(content).splitlines()


def _card(line: bytes) -> bytes | None:
    try:
        card = base64.b64decode(line, validate=True)
    except binascii.Error:
        return None
    return card if len(card) <= LARGEST else None
