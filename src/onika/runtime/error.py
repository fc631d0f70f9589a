"""The exceptions that a module raises, and those that the runtime raises in its name."""

from onika.words.module_sentence import Sentence, of_sentence
from onika.words.reason import NOTHING


class _Sentence(Exception):
    """An exception with a sentence of a module: `ModuleError("joint {joint} is beyond {limit}", joint=3, limit=2.1)`.

    Without arguments the sentence is taken as it is.
    """

    raised_at: tuple[str, int, str] | None = None
    """File, line and traceback, where it was raised in another process."""

    def __init__(self, sentence: Sentence = NOTHING, /, **arguments: object) -> None:
        super().__init__(of_sentence(sentence, arguments))


class ModuleError(_Sentence):
    """What a module raises when it cannot do its work; goes to its `error` entry first (dissertation §C.2)."""


class LawBroken(ModuleError):
    """What the law, not the module, finds wrong in a cycle: no `error` entry may mend it (law 5)."""


class AskAgain(_Sentence):
    """Raised by `on`: the input cannot be used, for this reason; the user is asked again."""


class RaisedElsewhere(_Sentence):
    """What else a module's code has raised in another process; its sentence is as it is to be shown."""
