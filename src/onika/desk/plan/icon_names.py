"""Names of icons, of their types and of steps, as sentences use them: what a user sees, never what files say."""

from collections.abc import Sequence

from onika.model.application import Branch, Hole, Icon, Step
from onika.model.onikon import Onikon
from onika.words.reason import Reason

_TARGET_WORD = "object"
"""The last word of a type of target, as files have it."""


def named(onikon: Onikon) -> str:
    """An icon by what it shows: its description, else its name."""
    return onikon.description or onikon.name


def quoted(onikon: Onikon) -> Reason:
    """The same where it stands in the middle of a sentence."""
    return Reason.of("run.quoted", text=named(onikon))


def step_named(step: Step) -> Reason | str:
    """A step by what it shows."""
    if isinstance(step, Icon):
        return named(step.onikon)
    if isinstance(step, Branch):
        return Reason.of("desk.a_branch")
    return Reason.of("desk.a_hole")


def several(steps: Sequence[Step]) -> Reason:
    """Some steps: by name where it is one, else how many; holes beside icons do not count."""
    solid = [step for step in steps if not isinstance(step, Hole)] or steps
    if len(solid) == 1:
        step = step_named(solid[0])
        return step if isinstance(step, Reason) else Reason.plain(step)
    return Reason.of("desk.icon_count", count=len(solid))


def kind_named(type_: str) -> Reason:
    """A type in words: what files call objects, people call targets."""
    kind, is_target = _kind(type_)
    if is_target:
        return Reason.of("run.target_kind", kind=kind)
    return Reason.plain(kind)


def a_kind(type_: str) -> Reason:
    """A type in words, with its article."""
    kind, is_target = _kind(type_)
    has_vowel = kind[:1].lower() in tuple("aeiou")
    if is_target:
        if has_vowel:
            return Reason.of("desk.an_target_kind", kind=kind)
        return Reason.of("desk.a_target_kind", kind=kind)
    if has_vowel:
        return Reason.of("desk.an_kind", kind=kind)
    return Reason.of("desk.a_kind", kind=kind)


def _kind(type_: str) -> tuple[str, bool]:
    """The words of a type without that which says that it is one of targets, and whether it is."""
    words = type_.split()
    is_target = len(words) > 1 and words[-1].lower() == _TARGET_WORD
    return " ".join(words[:-1] if is_target else words), is_target
