"""Names of icons, of their types and of steps, as sentences use them: what a user sees, never what files say."""

import re
from collections.abc import Iterable, Sequence

from onika.model.application import Branch, Hole, Icon, Step
from onika.model.onikon import Onikon
from onika.words.reason import Reason, Text

_OBJECT = re.compile(r"(?<=\w )(?<!\bthe )(?<!\ban )(?<!\bthis )object(?=s?\b)", re.IGNORECASE)
_TARGET_WORD = "object"
"""The last word of a type of target, as files have it."""


def named(onikon: Onikon) -> str:
    """An icon by what it shows: its description, else its name."""
    return onikon.description or onikon.name


def quoted(onikon: Onikon) -> str:
    """The same where it stands in the middle of a sentence."""
    return f"“{named(onikon)}”"


def step_named(step: Step) -> Text:
    """A step by what it shows."""
    if isinstance(step, Icon):
        return named(step.onikon)
    if isinstance(step, Branch):
        return Reason.of("desk.a_branch")
    return Reason.of("desk.a_hole")


def several(steps: Sequence[Step]) -> Text:
    """Some steps: by name where it is one, else how many; holes beside icons do not count."""
    solid = [step for step in steps if not isinstance(step, Hole)] or steps
    if len(solid) == 1:
        return step_named(solid[0])
    return Reason.of("desk.icon_count", count=len(solid))


def kind_named(type_: str) -> str:
    """A type in words: what files call objects, people call targets."""
    return in_words(" ".join(type_.split()))


def in_words(text: str) -> str:
    """A sentence in which types are named, with these in words: `a Joint object` is a Joint target."""
    return _OBJECT.sub("target", text)


def a(noun: str) -> str:
    """A noun with its article."""
    if noun[:1].lower() in "aeiou":
        return f"an {noun}"
    return f"a {noun}"


def a_kind(type_: str) -> Reason:
    """A type in words, with its article."""
    *words, last = type_.split() or [""]
    has_vowel = type_.lstrip()[:1].lower() in "aeiou"
    if words and last.lower() == _TARGET_WORD:
        kind = " ".join(words)
        if has_vowel:
            return Reason.of("desk.an_target_kind", kind=kind)
        return Reason.of("desk.a_target_kind", kind=kind)
    kind = kind_named(type_)
    if has_vowel:
        return Reason.of("desk.an_kind", kind=kind)
    return Reason.of("desk.a_kind", kind=kind)


def listed(names: Iterable[str]) -> str:
    """Names in a sentence: `one`, `one and other`, `one, other and third`."""
    *most, last = names
    return f"{', '.join(most)} and {last}" if most else last
