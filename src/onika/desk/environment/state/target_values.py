"""The values of a target: as words in forms, as typed values in icons (requirement D08)."""

from collections.abc import Mapping, Sequence

from onika.files.line import show_number
from onika.model.onikon import Onikon
from onika.model.syntax import Syntax
from onika.wire.view import ItemView
from onika.words.reason import NOTHING, Reason, reason_of
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


def checked(items: Sequence[ItemView], words: Words) -> Typed | dict[str, Reason]:
    """The values that words mean; else what is wrong with each, by `name`, or `name[2]` where there are several."""
    if len(words) != len(items):
        names = tuple(item.name for item in items) or Reason.of("desk.no_values")
        return {"values": Reason.of("desk.values_named", names=names, count=len(words))}
    wrong: dict[str, Reason] = {}
    wrong_values = []
    for item, some in zip(items, words, strict=True):
        if len(some) != item.count and not (item.dimension and some and len(some) % item.each == 0):
            wrong[item.name] = Reason.of("desk.value_count", count=item.count, given=len(some))
            continue
        values: list[Value] = []
        for index, word in enumerate(some):
            try:
                values.append(_value(item, index, word))
            except ValueError as why:
                wrong[item.name if item.count == 1 else f"{item.name}[{index}]"] = reason_of(why)
        wrong_values.append(tuple(values))
    return wrong or tuple(wrong_values)


def refusal_text(wrong: Mapping[str, Reason]) -> Reason:
    """Everything that is wrong as one sentence."""
    parts = tuple(Reason.of("desk.named_wrong", name=name, why=why) for name, why in wrong.items())
    return Reason.of("desk.several_reasons", reasons=parts)


def _value(item: ItemView, index: int, word: str) -> Value:
    """One value; raises ValueError whose reason says what is wrong with it."""
    kind = ValueType(item.type)
    if not (word if kind is ValueType.CHAR else word.strip()) and not kind.is_text:
        raise ValueError(Reason.of("desk.value_missing", range=_range(item, index)))
    if kind.is_text and any(not sign.isprintable() for sign in word):
        raise ValueError(Reason.of("desk.text_on_line", word=word))
    value = kind.parse(word if kind.is_text or kind is ValueType.CHAR else word.strip())
    if not isinstance(value, str):
        _within(item, index, value)
    return value


def _within(item: ItemView, index: int, value: float) -> None:
    unit = f" {item.unit}" if item.unit not in ("", "-") else ""
    if len(item.high or item.low or ()) <= index:
        return  # more than is usual: of those the robot says before the run
    if item.high is not None and value > item.high[index]:
        raise ValueError(Reason.of("desk.value_above", value=value, limit=item.high[index], unit=unit))
    if item.low is not None and value < item.low[index]:
        raise ValueError(Reason.of("desk.value_below", value=value, limit=item.low[index], unit=unit))


def _range(item: ItemView, index: int) -> Reason:
    if item.low is None or item.high is None or index >= len(item.low):
        return NOTHING
    unit = f" {item.unit}" if item.unit not in ("", "-") else ""
    return Reason.of("desk.value_range", low=item.low[index], high=item.high[index], unit=unit)


def _word(kind: ValueType, value: Value) -> str:
    if kind.is_real:
        return show_number(float(value))
    return str(value)
