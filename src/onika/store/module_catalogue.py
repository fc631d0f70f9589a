"""The catalogue of a module: what it says in another language, in `module/NAME.LANGUAGE.toml` beside its code.

A line is `"sentence" = "translation"`; a translation has the gaps of its sentence.
"""

import tomllib
from collections.abc import Iterable, Mapping, Set
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

Catalogue = Mapping[str, Mapping[str, str]]
"""What a module says in other languages: its translations by language and sentence."""


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


def reopen_catalogues(
    base: BaseDirectory, former: Mapping[str, Catalogue], changed: Set[Path]
) -> Mapping[str, Catalogue]:
    """The catalogues of a base directory's modules, by their names; of the former ones only those in `changed` anew."""
    catalogues = {}
    for module, files in _files(base).items():
        catalogue = former.get(module, {})
        if catalogue.keys() != files.keys() or not changed.isdisjoint(files.values()):
            catalogue = {language: _translations(path) for language, path in files.items()}
        catalogues[module] = catalogue
    return catalogues


def merged(opened: Iterable[Mapping[str, Catalogue]]) -> dict[str, dict[str, dict[str, str]]]:
    """The catalogues of a search path's modules, by their names; of one sentence the first translation counts."""
    merged_catalogues: dict[str, dict[str, dict[str, str]]] = {}
    for catalogues in opened:
        for module, catalogue in catalogues.items():
            earlier = merged_catalogues.setdefault(module, {})
            for language, translations in catalogue.items():
                earlier[language] = {**translations, **earlier.get(language, {})}
    return merged_catalogues


def translations_of(bases: Iterable[BaseDirectory], language: str) -> Mapping[str, str]:
    """What modules of a search path say in a language, by the keys of their sentences; what is at fault is left out."""
    catalogues = merged(reopen_catalogues(base, {}, frozenset()) for base in bases)
    return {
        key_of(module, sentence): translation
        for module, catalogue in catalogues.items()
        for sentence, translation in catalogue.get(language, {}).items()
    }


def _files(base: BaseDirectory) -> dict[str, dict[str, Path]]:
    """The files of catalogues beside the code of modules, by module and language."""
    modules = frozenset(base.modules)
    files: dict[str, dict[str, Path]] = {}
    for path in base.catalogue_files:
        module, _, language = path.name.removesuffix(".toml").rpartition(".")
        if module in modules and language in LANGUAGES[1:]:
            files.setdefault(module, {})[language] = path
    return files


def _translations(path: Path) -> Mapping[str, str]:
    content = text.load(path, str(path))[0]
    if content is None:
        return {}
    return read(content, str(path))[0]
