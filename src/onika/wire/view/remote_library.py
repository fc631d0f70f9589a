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
    changed: int = 0
    """Files before which a copy of the user's own stands that says something else."""
    has_all_rights: bool = False
    """Whether its code may do what its user may; else it computes in a sandbox."""


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


class OwnChangeView(View, frozen=True):
    """A file of a library before which a copy of the user's own stands that says something else."""

    path: str
    before: str = ""
    """What it was begun with; empty where there was nothing."""
    mine: str = ""
    is_text: bool = True
    """Whether both can be shown."""


class HeldFileView(View, frozen=True):
    """A file that was not sent, because others have changed it meanwhile."""

    path: str
    mine: str = ""
    other: str = ""
    """What they have made of it where both contradict, else both changes in one text."""
    contradicts: bool = False
    is_text: bool = True


class SentBackView(View, frozen=True):
    """What has become of own changes."""

    library: str
    version: int = 0
    """The version of the library in which they stand; 0: nothing was sent."""
    paths: tuple[str, ...] = ()
    merged: tuple[str, ...] = ()
    """Files that hold what others have changed, too; the own ones do so now as well."""
    is_behind: bool = False
    """Whether the library has more that is new, to which the user has to agree first."""
    held: tuple[HeldFileView, ...] = ()
    agreement: str = ""
    """Names what is held and merged, to be agreed to."""
    folder: str = ""
    """Where all versions of what is held lie as files."""
