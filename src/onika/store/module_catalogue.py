"""The catalogue of a module: what it says in another language, in `module/NAME.LANGUAGE.toml` beside its code.

A line is `"sentence" = "translation"`; a translation has the gaps of its sentence.
"""

import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path

from onika.files import text
from onika.store.base_directory import BaseDirectory
from onika.store.opened_text import Faults
from onika.words.fault import Fault, Place
from onika.words.module_sentence import key_of
from onika.words.reason import Reason
from onika.words.sentence import LANGUAGES, gaps

ENDINGS = tuple(f".{language}.toml" for language in LANGUAGES)
"""How the names of catalogues end."""


def read(content: str, place: str) -> tuple[Mapping[str, str], Faults]:
    """The translations of a catalogue by their sentences, and what is wrong with the rest."""
    instead = Reason.of("store.sentence_in_english")
    try:
        table = tomllib.loads(content)
    except tomllib.TOMLDecodeError as error:
        return {}, (Fault(Place(place), Reason.of("store.not_toml", why=str(error)), instead),)
    faults, translations = [], {}
    for sentence, translation in table.items():
        if isinstance(translation, str) and gaps(sentence) == gaps(translation):
            translations[sentence] = translation
        else:
            faults.append(Fault(Place(place), Reason.of("store.translation_unlike", sentence=sentence), instead))
    return translations, tuple(faults)


def translations_of(bases: Iterable[BaseDirectory], language: str) -> Mapping[str, str]:
    """What modules of a search path say in a language, by the keys of their sentences; what is at fault is left out."""
    sentences: dict[str, str] = {}
    for base in bases:
        for module in base.modules:
            for sentence, translation in _translations(base.code_file(module), language).items():
                sentences.setdefault(key_of(module, sentence), translation)
    return sentences


def _translations(code: Path, language: str) -> Mapping[str, str]:
    path = code.with_name(f"{code.stem}.{language}.toml")
    content = text.load(path, str(path))[0] if path.is_file() else None
    if content is None:
        return {}
    return read(content, str(path))[0]
