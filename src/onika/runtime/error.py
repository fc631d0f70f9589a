"""The exceptions that a module raises, and those that the runtime raises in its name."""


class ModuleError(Exception):
    """What a module raises when it cannot do its work; goes to its `error` entry first (dissertation §C.2)."""


class LawBroken(ModuleError):
    """What the law, not the module, finds wrong in a cycle: no `error` entry may mend it (law 5)."""


class AskAgain(Exception):
    """Raised by `on`: the input cannot be used, for this reason; the user is asked again."""
