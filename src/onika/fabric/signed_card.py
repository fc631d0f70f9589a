"""Cards as they travel: behind the signature of a site's key, one or many in a file (F06).

No router, server or stick has to be trusted for them; at most it keeps cards back.
"""

import re
from collections.abc import Iterable
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path

import zstandard

from onika.fabric import card as cards
from onika.fabric.card import VisitingCard
from onika.store.remote import signature as signatures
from onika.words.reason import Reason

NAMESPACE = "onika-card"
"""What is signed: a signature of a library is none of a card."""
MOST_CARDS = 5000
LARGEST_BOOK = 4_000_000
"""Bytes of a file of cards as it travels."""
_LARGEST_TEXT = 8_000_000
_HEAD = re.compile(rb"^-----BEGIN SSH SIGNATURE-----$", re.MULTILINE)
_MAGIC = b"\x28\xb5\x2f\xfd"


@dataclass(frozen=True, slots=True)
class SignedCard:
    """A card whose signature is good; whether its signer is whom one means is judged elsewhere."""

    card: VisitingCard
    signer: str
    """The fingerprint of the key."""


def signed(card: VisitingCard, key: Path, program: str = signatures.PROGRAM) -> bytes | Reason:
    """A card behind its signature by the key in a file."""
    try:
        text = cards.write(card)
    except ValueError as wrong:
        return wrong.args[0] if isinstance(wrong.args[0], Reason) else Reason.plain(str(wrong))
    whole = signatures.sign(text, key, program, NAMESPACE)
    if not isinstance(whole, Reason) and len(whole) > cards.LARGEST:
        return Reason.of("fabric.card_large", most=cards.LARGEST)
    return whole


def glance(content: bytes) -> SignedCard | Reason:
    """A card as it calls itself, before anybody has judged its signature: to be looked for, not to be shown."""
    parted = signatures.parted(content) if len(content) <= cards.LARGEST else Reason.of("fabric.card_line", line="CARD")
    if isinstance(parted, Reason):
        return parted
    signature, body = parted
    card = cards.read(body)
    return card if isinstance(card, Reason) else SignedCard(card, signature.fingerprint)


def opened(content: bytes, program: str = signatures.PROGRAM) -> SignedCard | Reason:
    """The card, once its signature has been judged good."""
    seen = glance(content)
    parted = signatures.parted(content)
    if isinstance(seen, Reason) or isinstance(parted, Reason):
        return seen if isinstance(seen, Reason) else Reason.of("store.signature_missing")
    fault = signatures.fault(*parted, program, NAMESPACE)
    return fault or seen


def bound(contents: Iterable[bytes]) -> bytes:
    """Signed cards as one file that any server of files gives away."""
    return zstandard.ZstdCompressor(level=19).compress(b"".join(contents))


def unbound(content: bytes) -> tuple[bytes, ...] | Reason:
    """The signed cards of such a file, packed or plain, none of them judged."""
    if content.startswith(_MAGIC):
        try:
            with zstandard.ZstdDecompressor(max_window_size=2**27).stream_reader(content) as stream:
                content = stream.read(_LARGEST_TEXT + 1)
        except (zstandard.ZstdError, MemoryError):
            return Reason.of("fabric.book_packed")
    if len(content) > _LARGEST_TEXT:
        return Reason.of("fabric.book_large", most=_LARGEST_TEXT)
    heads = [match.start() for match in _HEAD.finditer(content)]
    if len(heads) > MOST_CARDS:
        return Reason.of("fabric.book_many", most=MOST_CARDS)
    if heads[:1] != [0]:
        return Reason.of("fabric.book_form")
    return tuple(content[begin:end] for begin, end in zip(heads, [*heads[1:], len(content)], strict=True))


def digest(content: bytes) -> str:
    """Names a signed card."""
    return sha256(content).hexdigest()
