"""What a user does with libraries of others (requirements F03, F06, X16)."""

from onika.wire.act.act import Act


class ListRemoteLibraries(Act, frozen=True):
    """Ask which libraries of others are used; a tuple of `view.UsedLibraryView`."""


class BrowseLibrary(Act, frozen=True):
    """Look at a library at an address, whether it is used or not; the value is a `view.OfferView`. Nothing is kept."""

    address: str
    user: str = ""
    """Who asks, where the server wants to know; without a name `secret` is a token."""
    secret: str = ""


class TakeLibrary(Act, frozen=True):
    """Use what was looked at: its signer is trusted, and what its tasks write and touch is agreed to.

    Where it is used already the newer version takes its place. What is fetched is run by nobody.
    """

    address: str
    digest: str
    """Of the index that was shown: anything else is refused."""


class DropLibrary(Act, frozen=True):
    """Use a library of others no longer; what was placed of it stays."""

    library: str


class GiveLibraryRights(Act, frozen=True):
    """Let the code of a library do all that its user may, or compute and nothing else, from its next start on."""

    library: str
    all_rights: bool


class ListOwnChanges(Act, frozen=True):
    """Ask what the user's own copies change in a library of others; a tuple of `view.OwnChangeView`."""

    library: str


class SendBack(Act, frozen=True):
    """Send own changes back to the site of a library; the value is a `view.SentBackView`.

    Where others have changed the same meanwhile nothing is sent until the user has seen both.
    """

    library: str
    paths: tuple[str, ...]
    note: str = ""
    """What was changed, in the user's words; it stands in the audit trail of the site."""
    agreed: str = ""
    """Names the merged files that were shown and agreed to; what would be another merger is shown first."""
    is_mine: bool = False
    """Whether the user's own takes the place of theirs where both contradict."""
    user: str = ""
    secret: str = ""
    """As of `BrowseLibrary`."""
