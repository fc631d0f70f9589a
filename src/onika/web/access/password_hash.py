"""A password as it is kept: scrypt of it with a salt of its own (RFC 7914); whoever has the file has no password.

One look costs 32 MB and about a quarter of a second of a processor, for us and for whoever guesses.
"""

import hashlib
import hmac
import secrets
import unicodedata
from dataclasses import dataclass

from onika.words.reason import NOTHING, Reason

SHORTEST, LONGEST = 10, 256
"""Characters of a password."""
_NAME = "scrypt"
_COST, _BLOCK, _LANES = 15, 8, 3
_HIGHEST_COST, _MOST_LANES = 17, 8
_SALT, _DIGEST = 16, 32
_ROOM = 1024 * 1024


@dataclass(frozen=True, slots=True)
class PasswordHash:
    """What is kept of one password; cost is the power of two of RFC 7914, lanes its p."""

    salt: bytes
    digest: bytes
    cost: int = _COST
    lanes: int = _LANES

    def __str__(self) -> str:
        return f"{_NAME}:{self.cost}:{self.lanes}:{self.salt.hex()}:{self.digest.hex()}"

    @classmethod
    def of(cls, password: str, cost: int = _COST, lanes: int = _LANES) -> "PasswordHash":
        """A new one, with a salt that nobody else has."""
        salt = secrets.token_bytes(_SALT)
        return cls(salt, _derived(password, salt, cost, lanes), cost, lanes)

    @classmethod
    def parse(cls, text: str) -> "PasswordHash":
        """Read one; raises ValueError for anything else, and for what would take more memory than is given to it."""
        name, cost, lanes, salt, digest = text.split(":")
        made = cls(bytes.fromhex(salt), bytes.fromhex(digest), int(cost), int(lanes))
        is_sane = _COST <= made.cost <= _HIGHEST_COST and 1 <= made.lanes <= _MOST_LANES
        if name != _NAME or not is_sane or len(made.salt) != _SALT or len(made.digest) != _DIGEST:
            raise ValueError(text)
        return made

    def matches(self, password: str) -> bool:
        """Whether it is this password; takes its time."""
        return hmac.compare_digest(_derived(password, self.salt, self.cost, self.lanes), self.digest)


NOBODY = PasswordHash(bytes(_SALT), bytes(_DIGEST))
"""What is compared where there is no such user, so that the time does not tell; nothing matches it."""


def unfit(password: str, name: str) -> Reason:
    """Why this cannot be a user's password; empty: it can."""
    if not SHORTEST <= len(password) <= LONGEST:
        return Reason.of("desk.password_length", least=SHORTEST, most=LONGEST)
    if name.lower() in password.lower() or len(set(password)) < SHORTEST // 2:
        return Reason.of("desk.password_guessable")
    return NOTHING


def _derived(password: str, salt: bytes, cost: int, lanes: int) -> bytes:
    text = unicodedata.normalize("NFKC", password[:LONGEST]).encode("utf-8", "surrogatepass")
    count = 1 << cost
    memory = 128 * _BLOCK * (count + lanes) + _ROOM
    return hashlib.scrypt(text, salt=salt, n=count, r=_BLOCK, p=lanes, maxmem=memory, dklen=_DIGEST)
