"""The language in which the command line speaks: that of `--lang`, else of the variable ONIKA_LANG, else English.

It stands in the environment of the process, so that a program launched from here speaks it too.
"""

import os
from collections.abc import Iterable, Iterator
from contextlib import contextmanager

from onika.cli.safe_text import safe
from onika.store.base_directory import BaseDirectory
from onika.store.module_catalogue import translations_of
from onika.words.reason import Text, in_language
from onika.words.sentence import LANGUAGES

_VARIABLE = "ONIKA_LANG"
_of_modules: dict[str, str] = {}


def language() -> str:
    """The language of this process."""
    wanted = os.environ.get(_VARIABLE, "")
    return wanted if wanted in LANGUAGES else LANGUAGES[0]


@contextmanager
def speaking(wanted: str | None) -> Iterator[None]:
    """Speak the language meanwhile; None leaves it as it is."""
    former = os.environ.get(_VARIABLE)
    if wanted is not None:
        os.environ[_VARIABLE] = wanted
    try:
        yield
    finally:
        if former is not None:
            os.environ[_VARIABLE] = former
        else:
            os.environ.pop(_VARIABLE, None)


def learn(bases: Iterable[BaseDirectory]) -> None:
    """Take up what the modules of a search path say in the language of this process."""
    if language() != LANGUAGES[0]:
        _of_modules.update(translations_of(bases, language()))


def say(reason: Text) -> str:
    """The sentence of a reason in the language of this process; what it quotes brings no control sequences along."""
    return safe(in_language(reason, language(), _of_modules))
