"""Why a state variable makes no target, in words (requirements C30, X01)."""

from collections.abc import Iterable, Mapping

from onika.desk.plan.icon_names import kind_named
from onika.model.rules.target_fit import VariableValue, reasons_against
from onika.model.syntax import IconType
from onika.words.reason import Reason

_MOST = 3
"""Types that are named."""


def unfit(variable: VariableValue, kinds: Iterable[tuple[IconType, Mapping[str, str]]]) -> Reason:
    """What a variable is, and what the types that come nearest take instead; each type with the units of its data."""
    against = reasons_against(kinds, variable)[:_MOST]
    reasons = tuple(Reason.of("desk.kind_unfit", kind=kind_named(kind.name), why=why) for kind, why in against)
    return Reason.of("desk.fits_no_target", name=variable.name, given=variable.described, reasons=reasons)
