"""A pact: what two ends have to know so that a datagram of one counts with the other, and nobody else's does.

Its key is drawn where datagrams are to arrive and told over a link, behind its token. A datagram is a name, a count
that only grows, what is said, and a seal over all of it.
"""

import secrets
from dataclasses import dataclass
from hashlib import blake2b
from hmac import compare_digest

NAME, COUNT, SEAL, KEY = 8, 8, 16, 32
"""Lengths in bytes."""


@dataclass(frozen=True, slots=True)
class Pact:
    """Of one receiver, for one run."""

    name: bytes
    key: bytes

    def __repr__(self) -> str:
        """Without the key."""
        return f"Pact(name={self.name.hex()})"

    @classmethod
    def drawn(cls) -> "Pact":
        """A new one."""
        return cls(secrets.token_bytes(NAME), secrets.token_bytes(KEY))

    def seal(self, count: int, body: bytes) -> bytes:
        """The datagram that says this."""
        head = self.name + count.to_bytes(COUNT, "big") + body
        return head + sealed(self.key, head)

    def open(self, datagram: bytes) -> tuple[int, bytes] | None:
        """The count of a datagram and what it says; None: it does not count here."""
        head, seal = datagram[:-SEAL], datagram[-SEAL:]
        is_mine = len(head) >= NAME + COUNT and head[:NAME] == self.name
        if not is_mine or not compare_digest(seal, sealed(self.key, head)):
            return None
        return int.from_bytes(head[NAME : NAME + COUNT], "big"), head[NAME + COUNT :]


def sealed(key: bytes, head: bytes) -> bytes:
    """The seal over what is said."""
    return blake2b(head, digest_size=SEAL, key=key).digest()
