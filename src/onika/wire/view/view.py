"""A part of what is shown, and the words for a refusal."""

from msgspec import Struct

from onika.wire.act import AnyAct


class View(Struct, frozen=True, omit_defaults=True):
    """A part of what is shown."""


class Remedy(View, frozen=True):
    """A button beside a refusal: it sends `act`, or goes to what `show` names.

    show    `task:NAME`, `library:NAME`, `pin:TASK/PIN`, `locus:NAME`, `source:TASK`, `connect`, `problems`, `save-as`;
            in applications `step:NUMBER`, `onikon:NAME`, `fits:FLOW:NUMBER` (what fits behind that step), `target:TYPE`
            (make one), `values:NUMBER` (of a step), `loop:NUMBER`, `configuration:PATH`
    """

    label: str
    act: AnyAct | None = None
    show: str = ""


class Reason(View, frozen=True):
    """Why something is refused or worth a warning, in words, with what could be done, likeliest first (X01)."""

    text: str
    remedies: tuple[Remedy, ...] = ()
