"""Types of icons as they are named to people, in whatever language: what files call objects are targets."""

from collections.abc import Sequence

from onika.desk.plan.icon_names import kind_named
from onika.words.reason import Reason

_TARGET = " target"


def kind_text(type_: str) -> Reason:
    """A type in words."""
    name = kind_named(type_)
    is_target = name.endswith(_TARGET) and not type_.endswith(_TARGET)
    if is_target:
        return Reason.of("run.target_kind", kind=name.removesuffix(_TARGET))
    return Reason.plain(name)


def with_article(kind: Reason) -> Reason:
    """The same with its article."""
    is_vowel = str(kind)[:1].lower() in "aeiou"
    if is_vowel:
        return Reason.of("run.an_kind", kind=kind)
    return Reason.of("run.a_kind", kind=kind)


def kind_or_kinds(types: Sequence[str]) -> Reason:
    """One type in words, or several with the word between the last two."""
    kinds = tuple(map(kind_text, types))
    if len(kinds) == 1:
        return kinds[0]
    return Reason.of("run.of_either", kinds=kinds)
