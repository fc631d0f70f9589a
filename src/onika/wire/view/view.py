"""A part of what is shown, and the words for a refusal."""

from msgspec import Struct

from onika.wire.act import AnyAct
from onika.wire.view.show import AnyShow
from onika.words.reason import Reason


class View(Struct, frozen=True, omit_defaults=True):
    """A part of what is shown."""


class Remedy(View, frozen=True):
    """A button beside a refusal: it sends `act`, or goes to what `show` names."""

    label: Reason
    act: AnyAct | None = None
    show: AnyShow | None = None


class ChoiceView(View, frozen=True):
    """What can be done with a run that stands still."""

    verb: str
    """The word of steering that does it."""
    meaning: Reason
    """What it does."""
    subsystem: str = ""
    """The flow with which it is done, where there are several."""
    act: AnyAct | None = None
    """Does it; none where it is left open which action is meant."""


class Objection(View, frozen=True):
    """Why something is refused or worth a warning, in words, with what could be done, likeliest first (X01)."""

    text: Reason
    remedies: tuple[Remedy, ...] = ()
