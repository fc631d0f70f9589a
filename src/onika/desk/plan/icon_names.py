"""Names of icons, of their types and of steps, as sentences use them: what a user sees, never what files say."""

import re
from collections.abc import Iterable, Sequence

from onika.model.application import Branch, Hole, Icon, Step
from onika.model.onikon import Onikon

_OBJECT = re.compile(r"(?<=\w )(?<!\bthe )(?<!\ban )(?<!\bthis )object(?=s?\b)", re.IGNORECASE)


def named(onikon: Onikon) -> str:
    """An icon by what it shows: its description, else its name."""
    return onikon.description or onikon.name


def quoted(onikon: Onikon) -> str:
    """The same where it stands in the middle of a sentence."""
    return f"“{named(onikon)}”"


def step_named(step: Step) -> str:
    """A step by what it shows."""
    if isinstance(step, Icon):
        return named(step.onikon)
    return "a branch" if isinstance(step, Branch) else "a hole"


def several(steps: Sequence[Step]) -> str:
    """Some steps: by name where it is one, else how many; holes beside icons do not count."""
    solid = [step for step in steps if not isinstance(step, Hole)] or steps
    return step_named(solid[0]) if len(solid) == 1 else f"{len(solid)} icons"


def kind_named(type_: str) -> str:
    """A type in words: what files call objects, people call targets."""
    return in_words(" ".join(type_.split()))


def in_words(text: str) -> str:
    """A sentence in which types are named, with these in words: `a Joint object` is a Joint target."""
    return _OBJECT.sub("target", text)


def a(noun: str) -> str:
    """A noun with its article."""
    return f"an {noun}" if noun[:1].lower() in "aeiou" else f"a {noun}"


def a_kind(type_: str) -> str:
    """A type in words, with its article."""
    return a(kind_named(type_))


def listed(names: Iterable[str]) -> str:
    """Names in a sentence: `one`, `one and other`, `one, other and third`."""
    *most, last = names
    return f"{', '.join(most)} and {last}" if most else last
