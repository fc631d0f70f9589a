"""A site with a key that signs cards, and signatures that cost no process.

cmu = AnnouncedSite(tmp_path, "cmu.puma")
cmu.card(robots=("arm",))        # a signed card, as bytes
"""

import subprocess
from dataclasses import replace
from datetime import date
from pathlib import Path
from typing import Any

from onika.fabric.card import OfferedRuntime, VisitingCard
from onika.fabric.signed_card import SignedCard, opened, signed
from onika.words.reason import Reason

TODAY = date(2026, 11, 24)
CARD = VisitingCard(
    "cmu.puma",
    1000,
    date(2026, 12, 24),
    "Our PUMA",
    (OfferedRuntime("wss://robots.cmu.edu:7994", ("arm", "hand")),),
    ("https://robots.cmu.edu/puma",),
)


def signer(letter: str) -> str:
    """A fingerprint that no key has."""
    return f"SHA256:{letter * 43}"


def believed(name: str, key: str, serial: int = 1000, **more: Any) -> SignedCard:
    """A card that was judged good."""
    return SignedCard(replace(CARD, name=name, serial=serial, **more), signer(key))


class AnnouncedSite:
    """A site with a key of its own."""

    def __init__(self, folder: Path, name: str) -> None:
        self.name = name
        self.key = folder / f"{name}.key"
        words = ["ssh-keygen", "-q", "-t", "ed25519", "-N", "", "-C", name, "-f", str(self.key)]
        subprocess.run(words, check=True)

    def card(self, **more: Any) -> bytes:
        """A card of it, signed."""
        content = signed(replace(CARD, **{"name": self.name, **more}), self.key)
        if isinstance(content, Reason):
            raise TypeError(content)
        return content

    @property
    def signer(self) -> str:
        """The fingerprint of its key."""
        seen = opened(self.card())
        if isinstance(seen, Reason):
            raise TypeError(seen)
        return seen.signer
