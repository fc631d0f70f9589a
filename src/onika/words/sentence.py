"""A sentence with gaps, and how values fill them; `browser/src/texts/sentence.ts` follows the same rules.

A gap is `{name}`, or `{name:rule}` with one of these rules; `{{` and `}}` are braces.

- none: a text as it is, a number as Python writes it but 5.0 as 5, several values with commas between them
- `.3g`, `+.2f`, `9.3f`, `<9.3f` …: a number in Python's format of that name, of the kinds `g` and `f`
- `quoted`: a text in quotes, as Python writes it
- `and`, `or`: several values, the last two joined by that word of the language
- `;`: several values with semicolons between them
- `plural:action|actions`: the first word for one (a number, or a list of one), the second for any other number

A number has the decimal sign of the language. Where that is a comma, semicolons stand between several numbers with one.
What a person is to type or finds in a file comes as a text, which stays as it is.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache

LANGUAGES = ("en", "es")
"""The languages of the catalogues; the first is the one in which every sentence exists."""

_CONNECTIVES = {"en": {"and": "and", "or": "or"}, "es": {"and": "y", "or": "o"}}
_DECIMAL_SIGNS = {"en": ".", "es": ","}
_LISTS = ("", "and", "or", ";")
_GAP = re.compile(r"\{\{|\}\}|\{(\w+)(?::([^{}]*))?\}")
_NUMBER_FORMAT = re.compile(r"<?\+?\d*(\.\d+)?[gf]\Z")

_TEXTS = {str}

Show = Callable[[object], str]


def fill(sentence: str, arguments: Mapping[str, object], language: str, show: Show = str) -> str:
    """The sentence with its gaps filled; `show` writes a value that is no text, number or list.

    Raises KeyError where an argument is missing, ValueError where a rule is unknown or does not suit its value.
    """
    template, names = _template(sentence)
    if names:  # most sentences: a click on a canvas makes thousands
        values = tuple(map(arguments.__getitem__, names))
        if {*map(type, values)} == _TEXTS:
            return template % values
    parts = []
    for text, name, rule in _parts(sentence):
        parts.append(text)
        if name:
            parts.append(_filled(arguments[name], rule, language, show))
    return "".join(parts)


def gaps(sentence: str) -> frozenset[str]:
    """The names of the arguments that a sentence takes."""
    return frozenset(name for _, name, _ in _parts(sentence) if name)


@cache
def _template(sentence: str) -> tuple[str, tuple[str, ...]]:
    """The sentence in Python's `%` format and the names of its gaps; no names where a gap has a rule."""
    parts = _parts(sentence)
    if any(rule for _, _, rule in parts):
        return "", ()
    texts = (text.replace("%", "%%") + ("%s" if name else "") for text, name, _ in parts)
    return "".join(texts), tuple(name for _, name, _ in parts if name)


@cache
def _parts(sentence: str) -> tuple[tuple[str, str, str], ...]:
    """The sentence as texts, each with the name and the rule of the gap behind it, both empty where there is none."""
    return tuple(_parted(sentence))


def _parted(sentence: str) -> Iterator[tuple[str, str, str]]:
    end = 0
    for gap in _GAP.finditer(sentence):
        text = sentence[end : gap.start()]
        end = gap.end()
        yield (text, gap[1], gap[2] or "") if gap[1] else (text + gap[0][0], "", "")
    yield sentence[end:], "", ""


def _filled(value: object, rule: str, language: str, show: Show) -> str:
    kind, _, forms = rule.partition(":")
    if kind == "plural":
        singular, _, plural = forms.partition("|")
        count = len(value) if isinstance(value, tuple | list) else value
        return singular if count == 1 else plural

    if isinstance(value, tuple | list):
        each = "" if kind in _LISTS else rule
        return _listed(value, [_filled(item, each, language, show) for item in value], kind, language)

    if kind in _LISTS:
        return _written(value, language, show)
    if kind == "quoted":
        return repr(value if isinstance(value, str) else _written(value, language, show))
    if not _NUMBER_FORMAT.match(kind) or not isinstance(value, int | float):
        raise ValueError(f"expected a rule of a gap that suits {value!r}, found {rule!r}")
    return _with_sign(format(value, kind), language)


def _written(value: object, language: str, show: Show) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, float):
        is_whole = value.is_integer() and abs(value) < 1e16
        return str(int(value)) if is_whole else _with_sign(repr(float(value)), language)
    if isinstance(value, int):
        return str(value)
    return show(value)


def _with_sign(number: str, language: str) -> str:
    """A number as Python writes it, with the decimal sign of a language."""
    return number.replace(".", _DECIMAL_SIGNS[language])


def _listed(values: Sequence[object], items: Sequence[str], kind: str, language: str) -> str:
    """Several values, written as `items`; semicolons part numbers that have commas themselves."""
    has_commas = any("," in item and isinstance(value, int | float) for value, item in zip(values, items, strict=True))
    between = "; " if kind == ";" or has_commas else ", "
    connective = _CONNECTIVES[language].get(kind, "")
    if not connective or len(items) < 2:
        return between.join(items)
    return f"{between.join(items[:-1])} {connective} {items[-1]}"
