"""Present readings of variables as lines of a log (requirement A12).

A line for each variable: time in s, subsystem, name, type, then all values row by row, parted by blanks; texts in
double quotes as in an argument line.
"""

from onika.desk.run.value_text import type_of, words
from onika.wire import live

HEADER = "# TIME SUBSYSTEM NAME TYPE VALUES\n"


def rows(subsystem: str, values: live.Values) -> list[str]:
    """One line for each variable, by name."""
    types = types_of(values)
    return [
        f"{values.now_s:.6f} {subsystem} {name} {types[name]} {words(values.values[name])}"
        for name in sorted(values.values)
    ]


def types_of(values: live.Values) -> dict[str, str]:
    """The type of each variable: as the runtime says, else as its value looks."""
    return {name: values.types.get(name) or type_of(current) for name, current in values.values.items()}
