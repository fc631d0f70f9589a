"""The language in which the command line speaks: that of `--lang`, else that of the process."""

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from onika.cli.lines.safe_text import safe
from onika.words.own_language import VARIABLE, own_language
from onika.words.reason import Reason, in_language
from onika.words.sentence import LANGUAGES

if TYPE_CHECKING:
    from onika.store.base_directory import BaseDirectory

_of_modules: dict[str, str] = {}


@contextmanager
def speaking(wanted: str | None) -> Iterator[None]:
    """Speak the language meanwhile; None leaves it as it is."""
    former = os.environ.get(VARIABLE)
    if wanted is not None:
        os.environ[VARIABLE] = wanted
    try:
        yield
    finally:
        if former is not None:
            os.environ[VARIABLE] = former
        else:
            os.environ.pop(VARIABLE, None)


def learn(bases: "Iterable[BaseDirectory]") -> None:
    """Take up what the modules of a search path say in the language of this process."""
    if own_language() != LANGUAGES[0]:
        from onika.store.module_catalogue import translations_of  # within: a command may need no file at all

        _of_modules.update(translations_of(bases, own_language()))


def say(reason: Reason) -> str:
    """The sentence of a reason in the language of this process; what it quotes brings no control sequences along."""
    return safe(in_language(reason, own_language(), _of_modules))
