"""Making an icon of a document."""

from onika.wire.act.act import Act


class Draft(Act, frozen=True):
    """Ask what job a configuration would make; replied by `view.DraftView` (C16)."""

    doc: str


class MakeJob(Act, frozen=True):
    """Save the configuration and its onikon, with a picture as digits (C16, D07)."""

    doc: str
    picture: str
    description: str = ""
    overwrites: bool = False
