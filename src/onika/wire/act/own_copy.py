"""What a user does with copies of his own that stand before shipped files, and with texts that were replaced."""

from onika.wire.act.act import Act


class CompareWithShipped(Act, frozen=True):
    """Ask for a file of one's own and the shipped one before which it stands; `view.TwoTextsView`."""

    path: str


class GoBackToShipped(Act, frozen=True):
    """Go back to the shipped file: the copy goes where `BringBack` finds it. The value is the shipped one's path."""

    path: str


class ListReplaced(Act, frozen=True):
    """Ask for the texts that can be brought back, the newest first; a tuple of `view.ReplacedView`."""


class BringBack(Act, frozen=True):
    """Put a replaced text where it was; what stands there now is kept in its place. The value is the path."""

    number: int
