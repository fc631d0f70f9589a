"""Libraries of others, as a page shows them."""

from onika.wire.view.view import View
from onika.words.reason import Reason


class UsedLibraryView(View, frozen=True):
    """A library of others that is used."""

    name: str
    address: str
    signer: str
    """The fingerprint of the key."""
    trusted: str
    """Since when, and by whom."""
    version: int
    until: str
    """The last day on which its index may be taken for the newest."""
    folder: str
    """Its base directory."""
    lacking: int = 0
    """Files that are not fetched yet."""


class OfferEntryView(View, frozen=True):
    """One thing that a library offers: a task, configuration, icon, application or world."""

    kind: str
    name: str
    description: str = ""
    rows: tuple[str, ...] = ()
    """The rows of its picture."""
    writes: tuple[str, ...] = ()
    touches: tuple[str, ...] = ()
    is_new: bool = False


class OfferView(View, frozen=True):
    """A library as its place has it now."""

    address: str
    name: str
    version: int
    until: str
    signer: str
    digest: str
    """Names just this, to be taken."""
    description: str = ""
    entries: tuple[OfferEntryView, ...] = ()
    used: int = 0
    """The version that is used; 0: none."""
    further: tuple[tuple[str, tuple[str, ...]], ...] = ()
    """Of a library that is used: tasks, and what each would write or touch beyond what was agreed to."""
    refusal: Reason | None = None
    """Why it may not be taken in place of what is used."""
