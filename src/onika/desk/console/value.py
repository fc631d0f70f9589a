"""A variable's value as text, and the type it has as far as the value itself says (law 7)."""

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
        return [element for one in value for element in flat(one)]
    return [value]


def words(value: Any) -> str:
    """All elements in one line, such that an argument line or a file takes them again."""
    return join(_exact(one) for one in flat(value))


def shown(name: str, value: Any) -> list[str]:
    """The lines that show a variable to people: one for a scalar or a vector, one for each row of a matrix."""
    if not isinstance(value, list) or not value or not isinstance(value[0], list):
        return [f"{name} = {_row(value)}"]
    return [f"{name}[{index}] = {_row(row)}" for index, row in enumerate(value)]


def _row(value: Any) -> str:
    if not isinstance(value, list):
        return _short(value)
    return "  ".join(f"{_short(one):>9}" if not isinstance(one, str) else one for one in flat(value)).strip()


def _short(value: Any) -> str:
    if isinstance(value, float):
        return f"{value:.4f}" if value == 0 or 1e-3 <= abs(value) < 1e5 else f"{value:.3e}"
    return repr(value) if isinstance(value, str) else str(value)


def _exact(value: Any) -> str:
    return repr(value) if isinstance(value, float) else str(value)
