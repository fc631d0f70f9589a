"""What is otherwise in the worlds of a virtual runtime, as words of the command line that starts it (X23)."""

import re
from collections.abc import Iterable, Mapping

WORLD_VALUE = r"[A-Za-z]\w*\.[A-Za-z]\w*=[0-9][0-9.e+-]{0,30}"
_FORM = re.compile(WORLD_VALUE, re.ASCII)

WorldValues = dict[str, dict[str, float]]
"""By world and name."""


def world_values(words: Iterable[str]) -> WorldValues:
    """Of `WORLD.NAME=VALUE` each; raises ValueError for what is none."""
    values: WorldValues = {}
    for word in words:
        if not _FORM.fullmatch(word):
            raise ValueError(word)
        address, _, number = word.partition("=")
        world, _, name = address.partition(".")
        values.setdefault(world, {})[name] = float(number)
    return values


def options_of(shake: int | None, values: Mapping[str, Mapping[str, float]]) -> tuple[str, ...]:
    """How a runtime is started that begins so."""
    words = [] if shake is None else ["--shake", str(shake)]
    for world, named in sorted(values.items()):
        for name, value in sorted(named.items()):
            words += ["--world-value", f"{world}.{name}={value!r}"]
    return tuple(words)
