"""Names: of state variables (`Q^_REF`), of tasks and icons, and the aliases between them."""

import re
from collections.abc import Iterable, Mapping

SVAR_NAME = re.compile(r"[A-Z][A-Z0-9_^]*\Z")
"""A state variable: `^` means time derivative and is part of the name, never an operator."""

TASK_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.-]{0,199}\Z")
"""A task, job, target, application, module or processing unit: also a file name without its ending.

So long at most: names of files end at 255, and an ending, or what a file is called while it is saved, has to fit in."""


WORLD_NAME = re.compile(r"[A-Za-z][A-Za-z0-9_.-]{0,99}(?:@[A-Za-z0-9_.-]{1,99})?\Z")
"""A world as a device names it before its colon; behind the `@` a copy of its own of a simulated one."""


def resolve(names: Iterable[str], aliases: Mapping[str, str]) -> tuple[str, ...]:
    """Replace every coded name by its alias, once: A→B together with B→A swaps the two (requirement C04)."""
    return tuple(aliases.get(name, name) for name in names)
