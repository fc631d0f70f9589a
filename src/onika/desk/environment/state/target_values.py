"""The values of a target: as words in forms, as typed values in icons (requirement D08)."""

from collections.abc import Sequence

from onika.files.line import show_number
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.wire.view import ItemView
from onika.words.value import Value, ValueType

Words = tuple[tuple[str, ...], ...]
"""The words of every datum, in the order of the type."""

Typed = tuple[tuple[Value, ...], ...]


def shown(onikon: Onikon, syntax: Syntax | None) -> Words:
    """The values of an icon as words."""
    kind = syntax.find(onikon.type) if syntax else None
    items = kind.items if kind else ()
    if len(items) != len(onikon.values):
        return tuple(tuple(map(str, values)) for values in onikon.values)
    return tuple(
        tuple(_word(item.type, value) for value in values) for item, values in zip(items, onikon.values, strict=True)
    )


def checked(items: Sequence[ItemView], words: Words) -> Typed | dict[str, str]:
    """The values that words mean; else what is wrong with each, by `name`, or `name[2]` where there are several."""
    if len(words) != len(items):
        names = ", ".join(item.name for item in items) or "no values"
        return {"values": f"expected {names}, found {len(words)} values"}
    wrong: dict[str, str] = {}
    wrong_values = []
    for item, some in zip(items, words, strict=True):
        if len(some) != item.count and not (item.dimension and some):
            wrong[item.name] = f"expected {item.count} values, found {len(some)}"
            continue
        values: list[Value] = []
        for index, word in enumerate(some):
            try:
                values.append(_value(item, index, word))
            except ValueError as why:
                wrong[item.name if item.count == 1 else f"{item.name}[{index}]"] = str(why)
        wrong_values.append(tuple(values))
    return wrong or tuple(wrong_values)


def refusal_text(wrong: dict[str, str]) -> str:
    """Everything that is wrong as one sentence."""
    return "; ".join(f"{name}: {why}" for name, why in wrong.items())


def _value(item: ItemView, index: int, word: str) -> Value:
    """One value; raises ValueError whose text says what is wrong with it."""
    kind = ValueType(item.type)
    if not (word if kind is ValueType.CHAR else word.strip()) and not kind.is_text:
        raise ValueError(f"a value is missing{_range(item, index)}")
    if kind.is_text and any(not sign.isprintable() for sign in word):
        raise ValueError(f"expected text that fits on a line, found {word!r}")
    value = kind.parse(word if kind.is_text or kind is ValueType.CHAR else word.strip())
    if not isinstance(value, str):
        _within(item, index, value)
    return value


def _within(item: ItemView, index: int, value: float) -> None:
    unit = f" {item.unit}" if item.unit not in ("", "-") else ""
    if len(item.high or item.low or ()) <= index:
        return  # more than is usual: of those the robot says before the run
    if item.high is not None and value > item.high[index]:
        raise ValueError(f"{value:g} is above {item.high[index]:g}{unit}")
    if item.low is not None and value < item.low[index]:
        raise ValueError(f"{value:g} is below {item.low[index]:g}{unit}")


def _range(item: ItemView, index: int) -> str:
    if item.low is None or item.high is None or index >= len(item.low):
        return ""
    unit = f" {item.unit}" if item.unit not in ("", "-") else ""
    return f": expected {item.low[index]:g} to {item.high[index]:g}{unit}"


def _word(kind: ValueType, value: Value) -> str:
    return show_number(float(value)) if kind.is_real else str(value)
