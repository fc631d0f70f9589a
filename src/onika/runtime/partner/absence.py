"""The absence of a partner: what becomes of a synchronous task whose question is never answered (F04)."""

from onika.model.lifecycle import LifecycleInput


def without_partner(is_passive: bool) -> LifecycleInput:
    """A passive task falls silent; any other has a fault."""
    if is_passive:
        return LifecycleInput.OFF
    return LifecycleInput.FAIL
