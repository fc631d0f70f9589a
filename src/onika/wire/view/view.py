"""A part of what is shown, and the words for a refusal."""

from msgspec import Struct

from onika.wire.act import AnyAct
from onika.wire.view.show import AnyShow
from onika.words.reason import Text


class View(Struct, frozen=True, omit_defaults=True):
    """A part of what is shown."""


class Remedy(View, frozen=True):
    """A button beside a refusal: it sends `act`, or goes to what `show` names."""

    label: Text
    act: AnyAct | None = None
    show: AnyShow | None = None


class Objection(View, frozen=True):
    """Why something is refused or worth a warning, in words, with what could be done, likeliest first (X01)."""

    text: Text
    remedies: tuple[Remedy, ...] = ()
