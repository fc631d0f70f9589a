"""A reason: why something is so, as a key and its arguments. The sentence is made where people read it.

`Reason.of("rules.edge_unfit", left="a", right="b")` names a sentence of the catalogues and gives what stands in its
gaps; `str()` of a reason is its English. Programs look at `key` and `args`, never at the sentence (decision 34).
"""

from collections.abc import Iterator, Mapping
from types import MappingProxyType
from typing import Protocol, Self, runtime_checkable

from msgspec import Struct

from onika.words.catalogue import sentence
from onika.words.sentence import fill

PLAIN = "plain"
"""The key of a text that is in no catalogue."""


class Reason(Struct, frozen=True, omit_defaults=True):
    """A key of the catalogues, what fills the gaps of its sentence, and that sentence in English."""

    key: str
    text: str
    """The sentence in English, made when the reason is made: whoever does not know the key shows it."""
    args: "dict[str, str | int | float | bool | Reason | tuple[str | int | float | bool | Reason, ...]]" = {}

    @classmethod
    def of(cls, key: str, /, **args: "Argument") -> Self:
        """The reason of a key; raises KeyError where no sentence has it or an argument of the sentence is missing."""
        return cls(key, fill(sentence("en", key), args, "en"), args)

    @classmethod
    def plain(cls, text: str) -> Self:
        """A text that is in no catalogue: of a module, of the operating system, of a foreign program."""
        return cls(PLAIN if text else "", text)

    def __str__(self) -> str:
        return self.text

    def __bool__(self) -> bool:
        return bool(self.text)

    def __hash__(self) -> int:
        return hash((self.key, self.text))

    def __lt__(self, other: "Reason") -> bool:
        return (self.text, self.key) < (other.text, other.key)


Argument = str | int | float | bool | Reason | tuple[str | int | float | bool | Reason, ...]
"""What fills a gap of a sentence: one thing, or several; a reason within a reason is said in the same language."""


@runtime_checkable
class KeyedSentence(Protocol):
    """A sentence in English that has its key and its arguments with it, as those of the control laws do."""

    key: str
    arguments: Mapping[str, str | int | float]


NOTHING = Reason("", "")
"""The reason that says nothing."""


def in_language(reason: Reason, language: str, of_modules: Mapping[str, str] = MappingProxyType({})) -> str:
    """The sentence of a reason in a language, or its English where that language does not have it whole.

    `of_modules` has what modules say in that language, by the keys of their sentences.
    """
    if language == "en":
        return reason.text
    of_module = of_modules.get(reason.key)
    if of_module is not None and not reason.args:
        return of_module
    try:
        translation = sentence(language, reason.key) if of_module is None else of_module
        return fill(translation, reason.args, language, lambda value: _shown(value, language, of_modules))
    except (KeyError, ValueError):
        return reason.text


def _shown(value: object, language: str, of_modules: Mapping[str, str]) -> str:
    if isinstance(value, Reason):
        return in_language(value, language, of_modules)
    return str(value)


def every(reason: Reason) -> Iterator[Reason]:
    """A reason, then those that fill its gaps, and theirs."""
    yield reason
    for value in reason.args.values():
        for item in value if isinstance(value, tuple) else (value,):
            if isinstance(item, Reason):
                yield from every(item)


def reason_of(error: Exception) -> Reason:
    """Why something was raised: the reason it was raised with, else its text."""
    first = error.args[0] if error.args else None
    if isinstance(first, Reason | KeyedSentence):
        return as_reason(first)
    return Reason.plain(str(error))


def as_reason(sentence: object) -> Reason:
    """What somebody said, as a reason: with the key that it has, else plain."""
    if isinstance(sentence, Reason):
        return sentence
    if isinstance(sentence, KeyedSentence):
        return Reason(sentence.key, str(sentence), dict(sentence.arguments))
    return Reason.plain(str(sentence))
