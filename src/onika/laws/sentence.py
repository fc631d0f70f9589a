"""A sentence of the laws: English, with the key and the arguments by which it is said in other languages.

The laws know nothing of catalogues; who shows the sentence finds it there, under domain `laws`.
"""

from collections.abc import Mapping

Argument = str | int | float


class LawSentence(str):
    """A sentence in English whose gaps, `{name}` or `{name:.3f}` in its template, are filled by its arguments."""

    __slots__ = ("arguments", "key")

    key: str
    arguments: Mapping[str, Argument]

    def __new__(cls, key: str, template: str, /, **arguments: Argument) -> "LawSentence":
        """The sentence of a key, made of its English template."""
        sentence = super().__new__(cls, template.format(**arguments))
        sentence.key, sentence.arguments = key, arguments
        return sentence


def sentence_of(error: ValueError) -> str:
    """Why something was raised: the sentence it was raised with, else its text."""
    first = error.args[0] if error.args else None
    return first if isinstance(first, LawSentence) else str(error)


def joint_beyond(joint: int, value: float, unit: str, low: float, high: float) -> LawSentence:
    """A joint, counted from 1, that a pose would bring beyond its limits."""
    return LawSentence(
        "laws.joint_beyond",
        "joint {joint} would stand at {value:.3f} {unit}, beyond {low:.3f}..{high:.3f}",
        joint=joint,
        value=float(value),
        unit=unit,
        low=low,
        high=high,
    )


def no_element(name: str, number: int, count: int) -> LawSentence | None:
    """Why a parameter that names an element, counted from 0, names none of `count`; None: it names one."""
    if 0 <= number < count:
        return None
    return LawSentence(
        "laws.element_missing", "{name}: expected 0..{last}, found {found}", name=name, last=count - 1, found=number
    )
