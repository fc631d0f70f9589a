"""Formats the value of a variable as text, and guesses its type from the value (law 7)."""

from typing import Any

from onika.words.argument import join


def type_of(value: Any) -> str:
    """`int`, `double`, `string` or a vector of them with its dimensions, as in `double[6,4]`; what it cannot tell apart
    (float and double, short and long) goes by the widest name that the runtime uses itself."""
    dims: list[int] = []
    while isinstance(value, list) and value:
        dims.append(len(value))
        value = value[0]
    kind = "string" if isinstance(value, str) else "double" if isinstance(value, float) else "int"
    return kind + (f"[{','.join(map(str, dims))}]" if dims else "")


def flat(value: Any) -> list[Any]:
    """The elements, row by row."""
    if isinstance(value, list):
        return [element for row in value for element in flat(row)]
    return [value]


def words(value: Any) -> str:
    """All elements in one line, such that an argument line or a file takes them again."""
    return join(_exact(element) for element in flat(value))


def shown(name: str, value: Any) -> list[str]:
    """The lines that show a variable to people: one for a scalar or a vector, one for each row of a matrix."""
    rows = _rows(value)
    if not _is_matrix(value):
        return [f"{name} = {rows[0]}"]
    return [f"{name}[{index}] = {row}" for index, row in enumerate(rows)]


def in_a_line(value: Any) -> str:
    """The value as a table shows it: of a matrix its first row."""
    first, *more = _rows(value)
    if more:
        return f"{first} …"
    return first


def _is_matrix(value: Any) -> bool:
    return isinstance(value, list) and bool(value) and isinstance(value[0], list)


def _rows(value: Any) -> list[str]:
    """The elements as texts, a line for each row."""
    texts = _texts(value)
    if not _is_matrix(value):
        return ["  ".join(texts).strip()]
    width = len(texts) // len(value)
    return ["  ".join(texts[start : start + width]) for start in range(0, len(texts), width)]


def _texts(value: Any) -> list[str]:
    """The elements, all of one form and width, so that they can be compared with the eye."""
    elements = flat(value)
    largest = max((abs(element) for element in elements if isinstance(element, float)), default=0.0)
    is_plain = largest == 0.0 or 1e-3 <= largest < 1e5
    texts = [_short(element, is_plain) for element in elements]
    width = max(map(len, texts), default=0)
    return [f"{text:>{width}}" for text in texts]


def _short(value: Any, is_plain: bool) -> str:
    if isinstance(value, float):
        text = f"{value:.4f}" if is_plain else f"{value:.3e}"
        return text.removeprefix("-") if float(text) == 0.0 else text  # the noise of a zero has no sign
    if isinstance(value, str):
        return repr(value)
    return str(value)


def _exact(value: Any) -> str:
    if isinstance(value, float):
        return repr(value)
    return str(value)
